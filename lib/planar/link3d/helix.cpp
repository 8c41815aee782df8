#include "link3d/helix.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

namespace {

using toolpath::Role;
using toolpath::Span;

constexpr double kLeast = 0.3, kMost = 1.7; // of the layer's height: least and greatest thickness of a turn
constexpr double kMisfits = 0.01;           // share of a turn that may be thinner or thicker
constexpr double kSeam = 0.9;               // of a turn; places farther apart than this lie on both sides of its ends
constexpr double kTurnStep = 5;             // bead widths between the points of a turn, at most

// The region's curve from `entry` once around, in pieces of at most kTurnStep bead widths.
HelixLap turn(const WaitingRegion& r, const Entry& entry) {
    HelixLap out;
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

// The share of the turn, 0 to 1, at which the place nearest to p lies; nothing if that is more than `reach` mm away.
// Where the turn's ends meet, the end nearer to `t` counts.
std::optional<double> at(const HelixLap& turn, const SegmentIndex& index, Vec2 p, double t, double reach) {
    const auto place = index.nearest(p, reach);
    if (!place) return std::nullopt;
    const double at =
        turn.along[place->segment] + place->t * (turn.along[place->segment + 1] - turn.along[place->segment]);
    return std::abs(at - t) > kSeam ? std::round(t) : at;
}

} // namespace

bool winds_on(const State& state, const Entry& entry) {
    if (state.options.lift != Lift::helical || climbing(state) == 0 || leads_in(state)) return false;
    const auto& here = state.window[0];
    const auto& above = state.window[1];
    if (here.paths.curves.size() != 1 || above.paths.curves.size() != 1 || here.open || above.open) return false;
    const auto next =
        nearest_entry(above, entry.place.point, reaches(state, above).front() * (here.width + above.width) / 2);
    if (!next) return false;
    const HelixLap below = turn(here, entry), on = turn(above, *next);
    const SegmentIndex index(std::span(&below.line, 1));
    std::size_t misfits = 0;
    for (std::size_t i = 0; i < on.along.size(); ++i) {
        const auto place = at(below, index, on.line.points[i], on.along[i], here.width);
        const double gap = 1 + on.along[i] - place.value_or(0);
        misfits += !place || gap < kLeast || gap > kMost ? 1 : 0;
    }
    return static_cast<double>(misfits) <= kMisfits * static_cast<double>(on.along.size());
}

Bead wind(State& state, const Entry& entry, bool goes_on) {
    const auto& r = state.region();
    const HelixLap now = turn(r, entry);
    const double from = state.at->z, rise = r.paths.z - from, h = r.paths.height;
    std::optional<HelixLap>& under = state.column.lap;
    std::optional<SegmentIndex> below;
    if (under) below.emplace(std::span(&under->line, 1));
    Span rising = span(state, Role::bead);
    rising.width = now.line.width;
    Span top = rising;
    for (std::size_t i = 0; i < now.along.size(); ++i) {
        const Vec2 p = now.line.points[i];
        const double t = now.along[i], t_under = under ? at(*under, *below, p, t, 2 * r.width).value_or(t) : 1;
        rising.points.push_back(at_height(p, from + t * rise));
        rising.height.push_back(h * (under ? std::clamp(1 + t - t_under, kLeast, kMost) : std::max(kFaint, t)));
        top.points.push_back(at_height(p, r.paths.z));
        top.height.push_back(h * std::max(kFaint, 1 - t));
    }
    rising.points.front() = *state.at;
    put(state, std::move(rising));
    ++state.counts.turns;
    if (goes_on) {
        under = now;
    } else {
        under.reset();
        top.points.front() = *state.at;
        put(state, std::move(top));
    }
    return {now.line.points, now.line.width};
}

} // namespace filum::link3d
