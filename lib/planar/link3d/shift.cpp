#include "link3d/shift.hpp"

#include "link3d/strip_route.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

namespace {

constexpr double kAround = 3; // bead widths; how far beside the straight way a lane may lead
constexpr double kBest = 64;  // rank of a lane that ends at its goal

// The stretches of the curves whose segments' bounding boxes meet the box.
std::vector<std::vector<Vec2>> lines_in(std::span<const toolpath::Curve> curves, const Box2& box) {
    std::vector<std::vector<Vec2>> out;
    for (const auto& c : curves) {
        bool open = false;
        for (std::size_t i = 0; i + 1 < c.points.size() + (c.closed ? 1 : 0); ++i) {
            const Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
            const bool meets = std::min(a.x, b.x) <= box.hi.x && std::max(a.x, b.x) >= box.lo.x &&
                               std::min(a.y, b.y) <= box.hi.y && std::max(a.y, b.y) >= box.lo.y;
            if (meets && !open) out.push_back({a});
            if (meets) out.back().push_back(b);
            open = meets;
        }
    }
    return out;
}

// Whether beads lie on both sides of the place, so that a start there is hidden.
bool hidden(const WaitingRegion& r, const Place& place) {
    const auto& points = r.paths.curves[place.curve].points;
    const Vec2 d = points[(place.segment + 1) % points.size()] - points[place.segment];
    const double l = geom::norm(d);
    if (l < kSamePoint) return false;
    const Vec2 side = (r.width / l) * Vec2{-d.y, d.x};
    return r.index.nearest(place.point + side, 0.6 * r.width) && r.index.nearest(place.point - side, 0.6 * r.width);
}

} // namespace

bool apart(const State& state, const Bead& bead) {
    return geom::distance(bead.points.back(), state.front.start) >= kApart * state.region().width;
}

std::optional<std::vector<Vec2>> shift(State& state, std::uint32_t c, const Bead& bead) {
    const auto& above = state.window[1];
    const double width = (state.window[0].width + above.width) / 2;
    Column& column = state.column;
    const auto home = nearest_entry(above, column.home);
    if (home->place.distance > width) column.home = home->place.point;
    column.offset = start_offset(state.options.interlace, above.paths.own_layer());
    const Vec2 goal = along(above.paths.curves[home->place.curve], home->place, column.offset * width);
    const Vec2 from = bead.points.back();
    const auto curves = as_printed(state, c, bead);
    const SegmentIndex index(curves);
    const auto rank = [&](Vec2 p, bool inside) {
        const auto e = nearest_entry(above, p, reaches(state, above).front() * width);
        if (!e || geom::distance(e->place.point, state.front.start) < kApart * width) return 0;
        if (inside && !hidden(above, e->place)) return 0;
        return static_cast<int>(std::max(1.0, kBest - std::floor(geom::distance(e->place.point, goal) / width)));
    };
    for (const double around : {kAround, 3 * kAround}) {
        const Vec2 margin{around * width, around * width};
        Box2 box;
        box.add(from);
        box.add(goal);
        const auto lines = lines_in(curves, {box.lo - margin, box.hi + margin});
        for (const bool inside : {true, false}) {
            if (inside && state.options.seam != Seam::inside) continue;
            if (auto way = strip_route(lines, curves, index, from, state.window[0].width, kStrips,
                                       static_cast<int>(kBest), [&](Vec2 p, int) { return rank(p, inside); }))
                return way;
        }
    }
    return std::nullopt;
}

} // namespace filum::link3d
