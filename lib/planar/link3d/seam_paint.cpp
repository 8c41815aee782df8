#include "link3d/seam_paint.hpp"

#include "geom/segment.hpp"
#include "link3d/state.hpp"

#include <algorithm>
#include <cmath>

namespace filum::link3d {

namespace {

using geom::Segment;

constexpr double kBeside = 1; // bead widths: a face within this distance of a bead is beside it; the surface itself is
                              // half a bead away
constexpr double kStep = 0.5; // bead widths between the points of a face that are looked at

SeamPaint paint_of(const State& state) {
    const auto& paths = state.region().paths;
    return state.options.paint ? state.options.paint(paths.z - paths.height / 2) : SeamPaint{};
}

// The middle of the lines beside the region: the point of them that is nearest to their mean.
std::optional<Vec2> middle(const WaitingRegion& r, const std::vector<Segment>& lines) {
    std::vector<Vec2> points;
    Vec2 sum;
    for (const Segment& s : lines) {
        const int steps = std::max(1, static_cast<int>(std::ceil(geom::distance(s.a, s.b) / (kStep * r.width))));
        for (int k = 0; k < steps; ++k) {
            const Vec2 p = geom::lerp(s.a, s.b, (k + 0.5) / steps);
            if (!r.index.nearest(p, kBeside * r.width)) continue;
            points.push_back(p);
            sum = sum + p;
        }
    }
    if (points.empty()) return std::nullopt;
    const Vec2 mean = (1.0 / static_cast<double>(points.size())) * sum;
    return *std::ranges::min_element(points, {}, [&](Vec2 p) { return geom::distance(p, mean); });
}

bool beside(Vec2 p, const std::vector<Segment>& lines, double distance) {
    return std::ranges::any_of(lines,
                               [&](const Segment& s) { return geom::point_segment_distance(s.a, s.b, p) <= distance; });
}

} // namespace

Entry by_paint(State& state, const Entry& usual) {
    const SeamPaint paint = paint_of(state);
    const WaitingRegion& r = state.region();
    if (const auto p = middle(r, paint.wanted)) {
        ++state.counts.painted;
        return *nearest_entry(r, *p);
    }
    const double off = kBeside * r.width;
    const auto& curve = r.paths.curves[usual.place.curve];
    if (!curve.closed || !beside(usual.place.point, paint.unwanted, off)) return usual;
    std::optional<Vec2> best;
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
        const Vec2 a = curve.points[i], b = curve.points[(i + 1) % curve.points.size()];
        const int steps = std::max(1, static_cast<int>(std::ceil(geom::distance(a, b) / (kStep * r.width))));
        for (int k = 0; k < steps; ++k) {
            const Vec2 p = geom::lerp(a, b, static_cast<double>(k) / steps);
            const bool nearer =
                !best || geom::distance(p, usual.place.point) < geom::distance(*best, usual.place.point);
            if (nearer && !beside(p, paint.unwanted, off)) best = p;
        }
    }
    return best ? *nearest_entry(r, *best) : usual;
}

void count_passed_paint(State& state) {
    if (state.options.paint && middle(state.region(), paint_of(state).wanted)) ++state.counts.paint_passed;
}

} // namespace filum::link3d
