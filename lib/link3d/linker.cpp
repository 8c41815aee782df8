#include "link3d/linker.hpp"

#include "geom/segment.hpp"
#include "link3d/strip_route.hpp"

#include <algorithm>
#include <array>

namespace filum::link3d {

namespace {

using toolpath::Curve;
using toolpath::Role;
using toolpath::Span;

constexpr double kThin = 0.5;  // of the bead width: a bead laid where there is material already, or between two beads
constexpr double kSame = 1e-6; // mm; places nearer than this are one
constexpr double kMargin = 0.003; // mm; a jog keeps this far from other beads: more than a digit of the machine code
constexpr double kDrift = 0.5;    // bead widths per layer that an entry can be counted on to move
constexpr std::array kStrips{Strips{}, Strips{0.05, 0.8}}; // where a lane just fits: better a thick place than a stop
constexpr double kEnds = 0.01;                             // mm; but for this much at its ends, which lie on beads

bool climbs(const toolpath::RegionPaths& r) { return r.join == Join::vertical && !r.curves.empty(); }

double region_width(const toolpath::RegionPaths& r) {
    double sum = 0;
    for (const auto& c : r.curves) sum += mean_width(c);
    return r.curves.empty() ? 0 : sum / static_cast<double>(r.curves.size());
}

Vec3 at_height(Vec2 p, double z) { return {p.x, p.y, z}; }

} // namespace

void Linker::add(toolpath::RegionPaths region, const Emit& emit, Notes& notes) {
    SegmentIndex index(region.curves);
    const double width = region_width(region);
    bool closed = false, open = false;
    for (const auto& c : region.curves) (c.closed ? closed : open) = true;
    window_.push_back({std::move(region), std::move(index), width, closed, open});
    if (window_.size() > options_.look_ahead) print_front(emit, notes);
}

void Linker::finish(const Emit& emit, Notes& notes) {
    while (!window_.empty()) print_front(emit, notes);
}

void Linker::print_front(const Emit& emit, Notes& notes) {
    const auto& r = window_.front().paths;
    if (r.curves.empty()) {
        if (r.area > 0) notes.push_back({"", "region without a bead", r.area, "mm2", 1, r.layer});
        may_climb_ = false;
        window_.pop_front();
        return;
    }
    const Entry first = enter(emit, notes);
    std::vector<char> done(r.curves.size(), 0);
    Entry entry = first;
    const auto main = main_curve();
    for (std::size_t left = r.curves.size(); left > 0; --left) {
        if (main) done[*main] = left > 1 || *main == first.place.curve ? 1 : 0;
        if (left < r.curves.size()) entry = hop(done, emit);
        done[entry.place.curve] = 1;
        print_curve(entry, left == 1, emit);
    }
    joins_.clear();
    pin_.reset();
    printed_.add(window_.front().index.bounds(), r.z);
    may_climb_ = true;
    if (options_.connect == Connect::outside) last_ = std::move(window_.front().index);
    window_.pop_front();
}

// The curve of the front region that is to be printed last, unless the region is entered there: the one that is longer
// than all others together, if the next region climbs from this one; from there it is most likely in reach.
std::optional<std::uint32_t> Linker::main_curve() const {
    const auto& curves = window_.front().paths.curves;
    if (curves.size() < 2 || climbing() == 0) return std::nullopt;
    double all = 0, longest = 0;
    std::uint32_t main = 0;
    for (std::uint32_t c = 0; c < curves.size(); ++c) {
        const double l = length(curves[c].points);
        all += l;
        if (l > longest) longest = l, main = c;
    }
    return longest > all / 2 ? std::optional(main) : std::nullopt;
}

// Gets the nozzle to the front region's first curve.
Linker::Entry Linker::enter(const Emit& emit, Notes& notes) {
    const auto& r = window_.front();
    if (climbs(r.paths)) {
        if (const auto entry = climb(emit)) return *entry;
    } else if (r.paths.join == Join::beside && options_.connect == Connect::outside) {
        if (const auto entry = go_around(emit)) return *entry;
    }
    if (r.paths.join != Join::start && at_ &&
        (r.paths.join == Join::vertical || options_.connect == Connect::outside)) {
        ++counts_.broken;
        notes.push_back({"", "join broken, its ends are out of reach", 0, "", 1, r.paths.layer, at_->x, at_->y});
    }
    const Entry entry = start_entry();
    stop_and_travel(entry.place.point, emit);
    return entry;
}

// A plain lift, then a short jog to the nearest place of the front region: it cannot cross that region's beads.
std::optional<Linker::Entry> Linker::climb(const Emit& emit) {
    const auto& r = window_.front();
    const double rise = at_ ? r.paths.z - at_->z : 0;
    if (!may_climb_ || rise < 0.5 * r.paths.height || rise > 1.5 * r.paths.height) return std::nullopt;
    auto entry = nearest_entry(r, at_->xy(), options_.reach * r.width, {});
    if (!entry) return std::nullopt;
    *entry = drift(*entry);
    std::vector<Vec3> way{*at_, at_height(at_->xy(), r.paths.z)};
    if (entry->place.distance > kSame) way.push_back(at_height(entry->place.point, r.paths.z));
    ++counts_.lifts;
    counts_.lift_length += entry->place.distance;
    joins_.push_back({false, {at_->xy(), entry->place.point}, {kThin * r.width}});
    extrude(Role::lift, std::move(way), {kThin * r.width}, emit);
    return entry;
}

// A connector outside the part to the nearest place of the front region that can be reached so.
std::optional<Linker::Entry> Linker::go_around(const Emit& emit) {
    const auto& r = window_.front();
    if (!may_climb_ || !last_) return std::nullopt;
    Box2 box = printed_.bounds();
    box.add(r.index.bounds().lo), box.add(r.index.bounds().hi);
    const auto free = [&](Vec3 a, Vec3 b) {
        const bool leaves = a == *at_;
        const auto& own = leaves ? *last_ : r.index;
        return is_free(own, a.xy(), b.xy(), kMargin, kEnds, kEnds) &&
               !printed_.blocks(a, b, a.z - r.paths.height / 2, 2 * r.width, leaves);
    };
    std::optional<std::vector<Vec3>> best;
    std::optional<Entry> entry;
    for (const Place& p : r.index.extremes()) {
        if (!r.paths.curves[p.curve].closed) continue;
        auto way = around(box, 2 * r.width, *at_, at_height(p.point, r.paths.z), free);
        if (way && (!best || length(*way) < length(*best))) best = std::move(way), entry = Entry{p};
    }
    if (!best) return std::nullopt;
    ++counts_.connectors;
    counts_.connector_length += length(*best);
    extrude(Role::connector, std::move(*best), {r.width}, emit);
    return entry;
}

// The nozzle's way from one curve of the front region to the nearest one that is left.
Linker::Entry Linker::hop(std::span<const char> done, const Emit& emit) {
    const auto& r = window_.front();
    auto entry = nearest_entry(r, at_->xy(), std::numeric_limits<double>::infinity(), done).value();
    const Vec2 to = entry.place.point;
    const bool near = entry.place.distance <= options_.reach * r.width;
    if (near && is_free(r.index, at_->xy(), to, kMargin, kEnds, kEnds) && crosses_no_join(at_->xy(), to)) {
        joins_.push_back({false, {at_->xy(), to}, {kThin * r.width}});
        ++counts_.jogs;
        counts_.jog_length += entry.place.distance;
        if (entry.place.distance > kSame) extrude(Role::jog, {*at_, at_height(to, r.paths.z)}, {kThin * r.width}, emit);
    } else {
        stop_and_travel(to, emit);
    }
    return entry;
}

bool Linker::crosses_no_join(Vec2 a, Vec2 b) const {
    return std::none_of(joins_.begin(), joins_.end(),
                        [&](const Curve& j) { return geom::cross_properly(a, b, j.points[0], j.points[1]); });
}

// Prints one curve of the front region; the last one is left where the next region can be reached, if it can.
void Linker::print_curve(const Entry& entry, bool last, const Emit& emit) {
    const auto& r = window_.front();
    const Curve& curve = r.paths.curves[entry.place.curve];
    const bool turn = r.paths.layer % 2 != 0; // beads run the other way on every second layer
    const double gap = curve.closed ? cut_gap(curve) : 0;
    Bead bead = curve.closed ? cut(curve, entry.place, turn, gap) : run(curve, entry.against);
    if (pin_ && curve.closed) pin(bead, *pin_);
    const Waiting* next = last && window_.size() > 1 && climbs(window_[1].paths) ? &window_[1] : nullptr;
    const double reach = next != nullptr ? options_.reach * next->width : 0;
    const auto reaches = [&](Vec2 p) { return nearest_entry(*next, p, reach, {}).has_value(); };
    if (next == nullptr || reaches(bead.points.back())) return print(bead, emit);
    if (curve.closed) {
        Bead other = cut(curve, entry.place, !turn, gap);
        if (pin_) pin(other, *pin_);
        if (reaches(other.points.back())) return print(other, emit);
    }
    const auto way = lane(bead, entry.place.curve);
    if (!way) return print(bead, emit);
    thin_beside(bead, *way, kThin * r.width, r.width, kThin);
    print(bead, emit);
    std::vector<Vec3> points;
    for (const auto p : *way) points.push_back(at_height(p, r.paths.z));
    ++counts_.lanes;
    counts_.lane_length += length(*way);
    extrude(Role::jog, std::move(points), {kThin * r.width}, emit);
}

// The way from the end of the region's last bead, between its beads, to where the next regions are in reach: the next
// one, and of those behind it as many as possible, with what entries can drift until then.
std::optional<std::vector<Vec2>> Linker::lane(const Bead& bead, std::uint32_t curve) const {
    const auto& r = window_.front();
    std::vector<Curve> curves = r.paths.curves; // as printed: this one with its gap
    curves[curve] = {false, bead.points, {r.width}};
    curves.insert(curves.end(), joins_.begin(), joins_.end());
    std::vector<std::vector<Vec2>> lines;
    for (const auto& c : curves) {
        lines.push_back(c.points);
        if (c.closed) lines.back().push_back(c.points.front());
    }
    const SegmentIndex index(curves);
    const int best = static_cast<int>(climbing());
    const auto rank = [&](Vec2 p, int least) {
        const auto in_reach = [&](int k) {
            const auto& next = window_[static_cast<std::size_t>(k)];
            const double reach = std::min(options_.reach, 1.0) + kDrift * (k - 1); // the first with some to spare
            return nearest_entry(next, p, reach * next.width, {}).has_value();
        };
        for (int k = 1; k <= best; ++k)
            if (!in_reach(k)) return k - 1 < least ? 0 : k - 1;
        return best;
    };
    return strip_route(lines, index, bead.points.back(), r.width, kStrips, best, rank);
}

void Linker::stop_and_travel(Vec2 to, const Emit& emit) {
    const auto& r = window_.front().paths;
    if (at_) {
        Span s{Role::travel, stroke_, r.layer, r.region, travel(printed_, *at_, at_height(to, r.z), options_.head),
               {},           {}};
        counts_.travel_length += length(s.points);
        ++counts_.breaks;
        ++stroke_;
        at_ = s.points.back();
        emit(s);
    } else {
        at_ = at_height(to, r.z);
    }
    ++counts_.strokes;
    printed_.begin();
}

void Linker::extrude(Role role, std::vector<Vec3> points, std::vector<double> width, const Emit& emit) {
    const auto& r = window_.front().paths;
    at_ = points.back();
    emit(Span{role, stroke_, r.layer, r.region, std::move(points), std::move(width), {r.height}});
}

void Linker::print(const Bead& bead, const Emit& emit) {
    std::vector<Vec3> points;
    points.reserve(bead.points.size());
    for (const auto p : bead.points) points.push_back(at_height(p, window_.front().paths.z));
    if (geom::distance(points.front(), *at_) < kSame) points.front() = *at_; // spans chain exactly
    extrude(Role::bead, std::move(points), bead.width, emit);
}

} // namespace filum::link3d
