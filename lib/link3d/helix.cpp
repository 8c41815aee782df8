// True helical z (docs/algorithms/link3d.md#ramps-and-helices): each turn of a column rises evenly by one layer, as
// thick as the gap to the turn below it.
#include "link3d/linker.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

namespace {

using toolpath::Role;
using toolpath::Span;

constexpr double kLeast = 0.3, kMost = 1.7; // of the layer's height: how thick a turn may be
constexpr double kMisfits = 0.01;           // share of a turn that may be thinner or thicker
constexpr double kSeam = 0.9;               // of a turn: so far from each other are places on both sides of its ends
constexpr double kTurnStep = 5;             // bead widths between the points of a turn, at most

} // namespace

// The front region's curve from `entry` once around, in pieces; with how far each point is along it, 0 to 1.
Linker::Turn Linker::turn(const Waiting& r, const Entry& entry) {
    Turn out;
    const Bead b = cut(r.paths.curves[entry.place.curve], entry.place, false, 0);
    const double all = length(b.points);
    double s = 0;
    for (std::size_t i = 0; i < b.points.size(); ++i) {
        const double l = i > 0 ? geom::distance(b.points[i - 1], b.points[i]) : 0;
        const int pieces = std::max(1, static_cast<int>(std::ceil(l / (kTurnStep * r.width))));
        for (int k = i > 0 ? 1 : pieces; k <= pieces; ++k) {
            const double t = static_cast<double>(k) / pieces;
            const double from = b.width.size() == 1 ? b.width[0] : b.width[i > 0 ? i - 1 : 0];
            const double to = b.width.size() == 1 ? b.width[0] : b.width[i];
            out.line.points.push_back(i > 0 ? geom::lerp(b.points[i - 1], b.points[i], t) : b.points[i]);
            out.line.width.push_back(from + t * (to - from));
            out.along.push_back(std::min(1.0, (s + t * l) / all));
        }
        s += l;
    }
    return out;
}

// How far along the turn the place nearest to p is, 0 to 1; nothing if that is more than `reach` mm away.  Where the
// turn's ends meet, that end which is nearer to `t`.
std::optional<double> Linker::Turn::at(const SegmentIndex& index, Vec2 p, double t, double reach) const {
    const auto place = index.nearest(p, reach);
    if (!place) return std::nullopt;
    const double at = along[place->segment] + place->t * (along[place->segment + 1] - along[place->segment]);
    return std::abs(at - t) > kSeam ? std::round(t) : at;
}

// Whether the front region, entered there, and the next one can be turns of one helix.
bool Linker::winds_on(const Entry& entry) const {
    if (options_.lift != Lift::helical || climbing() == 0 || leads_in()) return false;
    const auto& here = window_[0];
    const auto& above = window_[1];
    if (here.paths.curves.size() != 1 || above.paths.curves.size() != 1 || here.open || above.open) return false;
    const auto next =
        nearest_entry(above, entry.place.point, reaches(above).front() * (here.width + above.width) / 2, {});
    if (!next) return false;
    const Turn below = turn(here, entry), on = turn(above, *next);
    const SegmentIndex index(std::span(&below.line, 1));
    std::size_t misfits = 0;
    for (std::size_t i = 0; i < on.along.size(); ++i) {
        const auto at = below.at(index, on.line.points[i], on.along[i], here.width);
        const double gap = 1 + on.along[i] - at.value_or(0);
        misfits += !at || gap < kLeast || gap > kMost ? 1 : 0;
    }
    return static_cast<double>(misfits) <= kMisfits * static_cast<double>(on.along.size());
}

// Prints the front region's one curve as a turn that rises from where the nozzle is.  The last turn of a helix is
// followed by one at its top that lays what is missing there; its end is the bead's that is returned.
Bead Linker::wind(const Entry& entry, bool goes_on, const Emit& emit) {
    const auto& r = window_.front();
    Turn now = turn(r, entry);
    const double from = at_->z, rise = r.paths.z - from, h = r.paths.height;
    std::optional<SegmentIndex> below;
    if (turn_) below.emplace(std::span(&turn_->line, 1));
    Span s{Role::bead, stroke_, r.paths.layer, r.paths.region, {}, now.line.width, {}};
    Span top = s;
    for (std::size_t i = 0; i < now.along.size(); ++i) {
        const double t = now.along[i];
        const double under = turn_ ? turn_->at(*below, now.line.points[i], t, 2 * r.width).value_or(t) : 1;
        s.points.push_back(at_height(now.line.points[i], from + t * rise));
        s.height.push_back(turn_ ? h * std::clamp(1 + t - under, kLeast, kMost) : h * std::max(kFaint, t));
        top.points.push_back(at_height(now.line.points[i], r.paths.z));
        top.height.push_back(h * std::max(kFaint, 1 - t));
    }
    s.points.front() = *at_;
    at_ = s.points.back();
    ++counts_.turns;
    emit(s);
    if (goes_on) {
        turn_ = now;
    } else {
        turn_.reset();
        top.points.front() = *at_;
        at_ = top.points.back();
        emit(top);
    }
    return {now.line.points, now.line.width};
}

} // namespace filum::link3d
