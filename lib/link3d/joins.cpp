// How the linker gets from one region to the next without stopping.
#include "link3d/linker.hpp"
#include "link3d/strip_route.hpp"

#include <algorithm>
#include <array>

namespace filum::link3d {

namespace {

using toolpath::Curve;
using toolpath::Role;

constexpr double kDrift = 0.5; // bead widths per layer that an entry can be counted on to move

} // namespace

// Whether the front region lies on the layer that the nozzle is on.
bool Linker::rises() const {
    const auto& r = window_.front().paths;
    const double rise = at_ ? r.z - at_->z : 0;
    return rise >= 0.5 * r.height && rise <= 1.5 * r.height;
}

// The entry of the front region nearest to the nozzle, if it is in reach, to which no bead of the region lies across
// the way.  Only an open curve can, as it has no entry where it is nearest.  If one lies across every way, the nearest
// entry; what it crosses is told when all of the region lies (settle.cpp).
std::optional<Linker::Entry> Linker::climb_to() const {
    const auto& r = window_.front();
    const Vec2 from = at_->xy();
    const double reach = reaches(r).back() * (r.width + width_before_) / 2;
    const auto nearest = nearest_entry(r, from, reach, {});
    if (!nearest || !r.open) return nearest;
    std::vector<char> tried(r.paths.curves.size(), 0);
    for (auto entry = nearest; entry; entry = nearest_entry(r, from, reach, tried)) {
        if (is_free(r.index, from, entry->place.point, 0, kEnds, kEnds)) return entry;
        tried[entry->place.curve] = 1;
    }
    return nearest;
}

// A plain lift, then a short jog to the front region.
std::optional<Linker::Entry> Linker::climb(const Emit& emit) {
    const auto& r = window_.front();
    if (!may_climb_ || !rises()) return std::nullopt;
    auto entry = climb_to();
    if (!entry) return std::nullopt;
    if (options_.interlace == Interlace::none && !turn_)
        *entry = drift(*entry); // else lanes lead wherever the column goes
    joins_.push_back({false, {at_->xy(), entry->place.point}, {kThin * r.width}});
    ++counts_.lifts;
    counts_.lift_length += entry->place.distance;
    if (turn_ || winds_on(*entry)) {
        winds_ = true;
        if (entry->place.distance > kSamePoint)
            extrude(Role::lift, {*at_, at_height(entry->place.point, at_->z)}, {kThin * r.width}, emit);
        return entry;
    }
    if (ramps(*entry)) {
        begin_ramp(*entry, emit);
        return entry;
    }
    std::vector<Vec3> way{*at_, at_height(at_->xy(), r.paths.z)};
    if (entry->place.distance > kSamePoint) way.push_back(at_height(entry->place.point, r.paths.z));
    extrude(Role::lift, std::move(way), {kThin * r.width}, emit);
    return entry;
}

// From the brim, where its last bead ends, straight over to the front region's nearest bead.
std::optional<Linker::Entry> Linker::step_in(const Emit& emit) {
    const auto& r = window_.front();
    if (!beside_last()) return std::nullopt;
    const auto entry = nearest_entry(r, at_->xy(), reaches(r).back() * (r.width + width_before_) / 2, {});
    if (!entry) return std::nullopt;
    const Vec2 from = at_->xy(), to = entry->place.point;
    if (!is_free(*last_, from, to, kMargin, kEnds, 0) || !is_free(r.index, from, to, kMargin, 0, kEnds))
        return std::nullopt;
    ++counts_.brims;
    jog(*entry, emit);
    return entry;
}

// Whether the region before, which is known as it was printed, is of the front region's layer.
bool Linker::beside_last() const { return may_climb_ && last_ && std::abs(at_->z - window_.front().paths.z) <= 1e-6; }

// Straight to a place of the front region, on its layer.
void Linker::jog(const Entry& entry, const Emit& emit) {
    const auto& r = window_.front();
    const Vec2 to = entry.place.point;
    joins_.push_back({false, {at_->xy(), to}, {kThin * r.width}});
    if (entry.place.distance > kSamePoint)
        extrude(Role::jog, {*at_, at_height(to, r.paths.z)}, {kThin * r.width}, emit);
}

// The curves of the front region as they are printed, the curve `c` as `bead`, with all that joins them.
std::vector<Curve> Linker::as_printed(std::uint32_t c, const Bead& bead, const std::vector<Vec2>& lane) const {
    std::vector<Curve> curves = window_.front().paths.curves;
    curves[c] = {false, bead.points, bead.width};
    curves.insert(curves.end(), joins_.begin(), joins_.end());
    if (lane.size() > 1) curves.push_back({false, lane, {window_.front().width}});
    return curves;
}

// How many of the next regions are in reach of p, with what entries drift until then; 0 if that is below `least`.
int Linker::rank_above(Vec2 p, int least, double reach) const {
    const int all = static_cast<int>(climbing());
    int k = 0;
    for (; k < all; ++k) {
        const auto& next = window_[static_cast<std::size_t>(k) + 1];
        if (!nearest_entry(next, p, (reach + kDrift * k) * (window_[0].width + next.width) / 2, {})) break;
    }
    return k < least ? 0 : k;
}

// Whether p, on the layer of the front region, has a straight way out of the part, or over to the next region.
bool Linker::sees_outside(Vec2 p, const SegmentIndex& own) const {
    const auto& r = window_.front();
    if (options_.connect == Connect::inside) {
        const auto next = nearest_entry(window_[1], p, std::numeric_limits<double>::infinity(), {});
        return next && is_free(own, p, next->place.point, kMargin, kEnds, 0);
    }
    const Box2 box = all_bounds();
    const double m = 2 * r.width;
    const Vec3 a = at_height(p, r.paths.z);
    const std::array<Vec2, 4> ends{
        {{box.lo.x - m, p.y}, {box.hi.x + m, p.y}, {p.x, box.lo.y - m}, {p.x, box.hi.y + m}}};
    return std::any_of(ends.begin(), ends.end(), [&](Vec2 b) {
        return leads_out(a, at_height(b, a.z), own, true) && misses_others(a, at_height(b, a.z), false);
    });
}

// Whether the next region can be reached from the end of the front region's last bead.
bool Linker::ends_well(std::uint32_t c, const Bead& bead, double reach) const {
    const Vec2 end = bead.points.back();
    if (next_ == Next::above)
        return nearest_entry(window_[1], end, reach * (window_[0].width + window_[1].width) / 2, {}).has_value();
    return sees_outside(end, SegmentIndex(as_printed(c, bead, {})));
}

// The way from the end of the region's last bead, between its beads, to where the next region is in reach, and of those
// behind it as many as possible; or to where it leads out.
std::optional<std::vector<Vec2>> Linker::lane(std::uint32_t c, const Bead& bead, double reach) const {
    const auto curves = as_printed(c, bead, {});
    std::vector<std::vector<Vec2>> lines;
    for (const auto& curve : curves) {
        lines.push_back(curve.points);
        if (curve.closed) lines.back().push_back(curve.points.front());
    }
    const SegmentIndex index(curves);
    const bool above = next_ == Next::above;
    const auto strips = std::span(kStrips).first(above ? kStrips.size() : 1); // whoever leaves the region needs room
    return strip_route(lines, curves, index, bead.points.back(), window_.front().width, strips,
                       above ? static_cast<int>(climbing()) : 1, [&](Vec2 p, int least) {
                           return above ? rank_above(p, least, reach) : sees_outside(p, index) ? 1 : 0;
                       });
}

// Sees to it that the front region's last bead can be left, if there is a way: as it is, the other way round (`other`;
// the same for an open curve), or by the lane that is returned.
std::optional<std::vector<Vec2>> Linker::leave(std::uint32_t c, Bead& bead, const std::function<Bead()>& other) {
    if (next_ == Next::anywhere) return std::nullopt;
    for (const double reach : reaches(window_[std::min<std::size_t>(1, window_.size() - 1)])) {
        if (ends_well(c, bead, reach)) return std::nullopt;
        if (Bead b = other(); ends_well(c, b, reach)) {
            bead = std::move(b);
            return std::nullopt;
        }
        if (auto way = lane(c, bead, reach)) {
            ++counts_.lanes;
            counts_.lane_length += length(*way);
            return way;
        }
        if (next_ == Next::outside) break;
    }
    return std::nullopt;
}

} // namespace filum::link3d
