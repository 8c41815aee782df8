#include "regions/gaps.hpp"

#include "base/error.hpp"
#include "base/number.hpp"
#include "geom/segment_grid.hpp"
#include "polygon/segments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

namespace filum::regions {

namespace {

using geom::Segment;
using geom::Vec2;
using polygon::Loops;

constexpr double kReachIn = 0.001; // mm that a patch reaches into the solid, so that rounding leaves no slit

// The places of the edges along their loops.
struct EdgePlaces {
    std::vector<std::uint32_t> loop; // the loop of each edge
    std::vector<double> at;          // mm, from the loop's first point to the edge's first
    std::vector<double> around;      // mm, perimeter of each loop
};

EdgePlaces edge_places(const Loops& loops) {
    EdgePlaces out;
    for (std::uint32_t l = 0; l < loops.size(); ++l) {
        const auto loop = loops[l];
        double s = 0;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            out.loop.push_back(l);
            out.at.push_back(s);
            s += geom::distance(loop[i], loop[(i + 1) % loop.size()]);
        }
        out.around.push_back(s);
    }
    return out;
}

// The length of the shorter way along the outline between points of two edges, mm; infinite on different outlines.
double way(const EdgePlaces& c, std::uint32_t e, double on_e, std::uint32_t f, double on_f) {
    if (c.loop[e] != c.loop[f]) return std::numeric_limits<double>::infinity();
    const double d = std::abs(c.at[e] + on_e - c.at[f] - on_f);
    return std::min(d, c.around[c.loop[e]] - d);
}

// A nearest pair of points of two edges that do not cross.
struct Nearest {
    Vec2 p, q;
    double d = std::numeric_limits<double>::infinity();
};
Nearest nearest(const Segment& e, const Segment& f) {
    Nearest out;
    const auto take = [&](Vec2 p, Vec2 q) {
        if (const double d = geom::distance(p, q); d < out.d) out = {p, q, d};
    };
    for (const Vec2 p : {e.a, e.b}) take(p, geom::nearest_point(f.a, f.b, p));
    for (const Vec2 q : {f.a, f.b}) take(geom::nearest_point(e.a, e.b, q), q);
    return out;
}

// Whether the boxes of both edges are at least `width` apart along an axis, and so both edges.
bool clearly_apart(const Segment& e, const Segment& f, double width) {
    const double more = width * (1 + 1e-6); // more than what rounding can change
    const auto apart = [&](double a, double b, double c, double d) {
        return std::max(a, b) + more <= std::min(c, d) || std::max(c, d) + more <= std::min(a, b);
    };
    return apart(e.a.x, e.b.x, f.a.x, f.b.x) || apart(e.a.y, e.b.y, f.a.y, f.b.y);
}

// Whether each point is outside the solid beside the other edge.
bool face_each_other(const Segment& e, const Segment& f, const Nearest& n) {
    const auto outside = [](const Segment& s, Vec2 p) { return geom::cross(s.b - s.a, p - s.a) <= 0; };
    return outside(e, n.q) && outside(f, n.p);
}

// The part of e that is nearer than `width` to f: an interval, because both are convex.
std::optional<Segment> part_near(const Segment& e, const Segment& f, const Nearest& n, double width) {
    const double l = geom::distance(e.a, e.b);
    if (l == 0) return std::nullopt;
    const double middle = std::clamp(geom::dot(n.p - e.a, e.b - e.a) / (l * l), 0.0, 1.0);
    const auto near = [&](double t) {
        const Vec2 p = geom::lerp(e.a, e.b, t);
        return geom::point_segment_distance(f.a, f.b, p) < width;
    };
    const auto end = [&](double from, double to) { // the last place that is near, to a thousandth of the width
        if (near(to)) return to;
        while (std::abs(to - from) * l > width / 1000) {
            const double t = (from + to) / 2;
            (near(t) ? from : to) = t;
        }
        return from;
    };
    return Segment{geom::lerp(e.a, e.b, end(middle, 0)), geom::lerp(e.a, e.b, end(middle, 1))};
}

// The convex hull of a few points, counter-clockwise (Andrew 1979); fewer than three if they lie on a line.
std::vector<Vec2> hull(std::vector<Vec2> p) {
    std::sort(p.begin(), p.end(), [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    p.erase(std::unique(p.begin(), p.end()), p.end());
    std::vector<Vec2> out;
    for (int side = 0; side < 2; ++side) {
        const std::size_t first = out.size();
        for (const Vec2 q : p) {
            while (out.size() >= first + 2 && geom::orient(out[out.size() - 2], out.back(), q) <= 0) out.pop_back();
            out.push_back(q);
        }
        out.pop_back();
        std::reverse(p.begin(), p.end());
    }
    return out;
}

// The patch: the hull of both parts and a little of the solid behind them.
std::vector<Vec2> patch(const Segment& e, const Segment& f) {
    std::vector<Vec2> points;
    for (const Segment& s : {e, f}) {
        const double l = geom::distance(s.a, s.b);
        const Vec2 in = l > 0 ? (kReachIn / l) * geom::left_of(s.b - s.a) : Vec2{};
        for (const Vec2 p : {s.a, s.b}) {
            points.push_back(p);
            points.push_back(p + in);
        }
    }
    return hull(std::move(points));
}

// The pairs of edges that may be nearer to each other than `width`, each with its first edge first, ascending.
std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::span<const Segment> edges, double width) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    geom::SegmentPairs pairs(edges, geom::cell_for(edges, 2 * width), width / 2);
    for (std::uint32_t j = 0; j < edges.size(); ++j)
        pairs.add(j, [&](std::uint32_t i) {
            if (!clearly_apart(edges[i], edges[j], width)) out.emplace_back(i, j);
        });
    std::sort(out.begin(), out.end());
    return out;
}

[[noreturn]] void refuse(Vec2 at, double length, double width, int layer) {
    throw Error(Exit::bad_input, "cannot close the gaps of layer " + std::to_string(layer) + ": along more than " +
                                     fixed_text(length / 1000, 0) +
                                     " m its outlines run nearer to each other than a hairline of " +
                                     fixed_text(width, 3) + " mm, as at " + fixed_text(at.x, 2) + "," +
                                     fixed_text(at.y, 2) + "; no bead fits between such spikes: smooth the mesh there");
}

} // namespace

Loops bridges(const Loops& loops, double width, int layer) {
    Loops out;
    const auto edges = polygon::segments(loops);
    if (edges.empty()) return out;
    const EdgePlaces along = edge_places(loops);
    const geom::Box2 box = polygon::bounds(loops);
    const double most = kMostGaps * geom::distance(box.lo, box.hi);
    double length = 0; // mm, of the patches
    for (const auto& [i, j] : near_pairs(edges, width)) {
        const Segment &e = edges[i], &f = edges[j];
        const Nearest n = nearest(e, f);
        if (n.d >= width || !face_each_other(e, f, n)) continue;
        const double between = way(along, i, geom::distance(e.a, n.p), j, geom::distance(f.a, n.q));
        if (between <= std::numbers::pi * width) continue;
        const auto on_e = part_near(e, f, n, width), on_f = part_near(f, e, {n.q, n.p, n.d}, width);
        if (!on_e || !on_f) continue;
        const auto points = patch(*on_e, *on_f);
        if (points.size() < 3) continue;
        out.add(points);
        length += std::max(geom::distance(on_e->a, on_e->b), geom::distance(on_f->a, on_f->b));
        if (length > most) refuse(on_e->a, most, width, layer);
    }
    return out;
}

} // namespace filum::regions
