#include "link3d/entry.hpp"

#include "geom/segment.hpp"

#include <algorithm>
#include <limits>

namespace filum::link3d {

namespace {

constexpr double kInside = 0.8; // bead widths; a point farther than this from all beads of a region is outside it
constexpr double kFar = 100;    // sizes of a region; from a point so far back, the nearest place is the rearmost one

// Whether the jog a -> b keeps off all beads of the front region's curve, except at its ends. It may cross only the
// segment on which it begins. It must also stay so near to that curve that it cannot meet a neighbour of the region.
bool leads_free(const State& state, Vec2 a, Vec2 b, std::optional<std::uint32_t> on) {
    const double l = geom::distance(a, b);
    if (l <= kSamePoint) return true;
    const double ends = std::min(1.0, kEnds / l);
    const Vec2 last = geom::lerp(b, a, kSamePoint / l), off = geom::lerp(b, a, ends),
               away = geom::lerp(a, b, std::min(1.0, 2 * kOn / l));
    Box2 box;
    box.add(a);
    box.add(last);
    box.lo = box.lo - Vec2{kMargin, kMargin};
    box.hi = box.hi + Vec2{kMargin, kMargin};
    bool free = true;
    state.region().index.within(box, [&](std::uint32_t s, Vec2 c, Vec2 d) {
        const bool at_begin = on && geom::point_segment_distance(c, d, a) <= 2 * kOn;
        const bool apart = l <= kEnds || geom::segment_distance(at_begin ? away : a, off, c, d) > kMargin;
        return free = apart && (s == on || !geom::cross_properly(a, last, c, d));
    });
    if (l <= kEnds) return free;
    const auto& r = state.region();
    for (int k = 0; k < 8 && free; ++k)
        free = r.index.nearest(geom::lerp(a, b, k / 8.0), kInside * r.width).has_value();
    return free;
}

// The place within `step` mm of the nozzle that is nearest to `to` and can be reached freely; `nearest` if there is
// none.
Entry step_towards(const State& state, const Entry& nearest, Vec2 to, double step) {
    const auto& r = state.region();
    const Vec2 from = state.at->xy();
    struct Candidate {
        double left; // mm from the goal
        std::uint32_t segment;
        double t;
    };
    std::vector<Candidate> candidates;
    const bool on = nearest.place.distance < kOn;
    const double least = geom::distance(nearest.place.point, to) - 0.1 * r.width;
    r.index.within({from - Vec2{step, step}, from + Vec2{step, step}}, [&](std::uint32_t s, Vec2 a, Vec2 b) {
        // The part of a -> b inside the circle, and its point nearest to the goal.
        const double l = geom::distance(a, b), foot = l > 0 ? geom::dot(from - a, b - a) / (l * l) : 0;
        const double off = geom::distance(geom::lerp(a, b, foot), from);
        if (off > step) return true;
        const double half = l > 0 ? std::sqrt(step * step - off * off) / l : 0;
        const double lo = std::max(0.0, foot - half), hi = std::min(1.0, foot + half);
        if (lo > hi) return true;
        const double t = std::clamp(geom::nearest_parameter(a, b, to), lo, hi);
        if (on && geom::point_segment_distance(a, b, from) <= 2 * kOn) return true; // along the bead
        if (const double left = geom::distance(geom::lerp(a, b, t), to); left < least)
            candidates.push_back({left, s, t});
        return true;
    });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.left < b.left; });
    for (std::size_t i = 0; i < std::min<std::size_t>(candidates.size(), 32); ++i) {
        const Place found = r.index.place(candidates[i].segment, candidates[i].t, from);
        if (!r.paths.curves[found.curve].closed) continue;
        const Place place = at_corner(found, r.paths.curves[found.curve], from);
        if (leads_free(state, from, place.point, on ? std::optional(nearest.place.segment) : std::nullopt))
            return {place, false};
    }
    return nearest;
}

} // namespace

Entry start_entry(const State& state) {
    const auto& r = state.region();
    Vec2 p = state.at ? state.at->xy() : r.index.bounds().lo;
    const std::size_t n = climbing(state);
    if (state.options.seam == Seam::inside) {
        const Box2 box = state.window[n].index.bounds();
        p = geom::lerp(box.lo, box.hi, 0.5);
    } else if (state.options.seam == Seam::back) { // the middle of the rear, from so far that x hardly counts
        const Box2 box = state.window[n].index.bounds();
        p = {(box.lo.x + box.hi.x) / 2, box.hi.y + kFar * (box.hi.x - box.lo.x + box.hi.y - box.lo.y)};
    } else if (state.options.seam == Seam::place) {
        p = state.options.seam_at;
    }
    // The stroke should leave the last region of the column on the side of the next region.
    if (state.options.connect == Connect::inside && n + 1 < state.window.size() && !state.window[n + 1].index.empty()) {
        const Box2 here = state.window[n].index.bounds();
        p = state.window[n]
                .index.nearest(state.window[n + 1].index.nearest(geom::lerp(here.lo, here.hi, 0.5))->point)
                ->point;
    }
    // Goes down from the last known region of the column, so that the column can be climbed from the start.
    for (std::size_t k = n; k > 0; --k) {
        const auto& above = state.window[k];
        if (const auto e = nearest_entry(above, p); e->place.distance > above.width / 2) p = e->place.point;
    }
    return *nearest_entry(r, p);
}

std::optional<Entry> other_end(const State& state, const Entry& entry) {
    const auto& curves = state.region().paths.curves;
    const toolpath::Curve& curve = curves[entry.place.curve];
    if (curve.closed || curves.size() > 1 || state.front.next != NextPlace::above) return std::nullopt;
    const auto left = [&](Vec2 end) { // mm from there to the next region
        return nearest_entry(state.window[1], end)->place.distance;
    };
    const Vec2 here = entry.place.point, there = entry.against ? curve.points.front() : curve.points.back();
    if (left(there) <= left(here) + state.window[0].width / 2) return std::nullopt;
    const auto segment = entry.against ? 0 : static_cast<std::uint32_t>(curve.points.size()) - 2;
    return Entry{{0, segment, entry.against ? 0.0 : 1.0, there, 0}, !entry.against};
}

Entry drift(State& state, const Entry& nearest) {
    const auto& r = state.region();
    const Vec2 from = state.at->xy();
    if (!r.paths.curves[nearest.place.curve].closed || r.paths.curves.size() > 1) return nearest;
    for (std::size_t k = 1, n = climbing(state); k <= n; ++k) {
        const auto goal = nearest_entry(state.window[k], from);
        if (goal->place.distance <= state.options.reach / 2 * state.window[k].width) continue; // half stays in reserve
        const Vec2 to = goal->place.point;
        const double step = std::min(state.options.reach * r.width,
                                     std::max(r.width, 1.5 * goal->place.distance / static_cast<double>(k)));
        const Entry entry = step_towards(state, nearest, to, step);
        if (entry.place.point != nearest.place.point && nearest.place.distance < kOn) state.front.pin = from;
        return entry;
    }
    return nearest;
}

} // namespace filum::link3d
