#include "slice/bodies.hpp"

#include "geom/segment_grid.hpp"

#include <algorithm>
#include <cmath>

namespace filum::slice {

namespace {

using geom::Box2;
using geom::Vec2;
using polygon::Loops;

constexpr double kRounding = 0.001; // mm; closer faces differ only by rounding; bridges reach this far into the solid

struct Edge {
    Vec2 a, b;
    std::uint32_t loop, at, size; // its loop, its position in the loop, and the loop's number of edges
};

std::vector<Edge> edges_of(const Loops& loops) {
    std::vector<Edge> out;
    out.reserve(loops.points.size());
    for (std::uint32_t i = 0; i < loops.size(); ++i) {
        const auto loop = loops[i];
        const auto n = static_cast<std::uint32_t>(loop.size());
        for (std::uint32_t k = 0; k < n; ++k) out.push_back({loop[k], loop[(k + 1) % n], i, k, n});
    }
    return out;
}

bool neighbours(const Edge& e, const Edge& f) {
    if (e.loop != f.loop) return false;
    const std::uint32_t d = e.at > f.at ? e.at - f.at : f.at - e.at;
    return d <= 1 || d + 1 >= e.size;
}

// Finds the stretch of e along which f runs in the opposite direction within `width`. Distances are positive on the
// right of e, which is outside; they may go down to -1 um, for rounding. Returns in `out` the parameters on e and the
// distances at both ends; false if there is no such stretch.
struct FacingStretch {
    double u[2], gap[2];
};
bool facing(const Edge& e, const Edge& f, double width, FacingStretch& out) {
    const Vec2 d = e.b - e.a, g = f.b - f.a;
    const double l = norm(d);
    if (!(l > 0) || dot(d, g) > -0.9 * l * norm(g)) return false;
    const auto along = [&](Vec2 p) { return dot(p - e.a, d) / (l * l); };
    const auto right = [&](Vec2 p) { return cross(p - e.a, d) / l; };
    double u0 = along(f.b), u1 = along(f.a), h0 = right(f.b), h1 = right(f.a); // f runs against e
    if (!(u1 > u0)) return false;
    const double slope = (h1 - h0) / (u1 - u0);
    const auto cut = [&](double u, bool low) { // moves one end of the stretch to u
        if (low && u > u0) {
            h0 += slope * (u - u0);
            u0 = u;
        }
        if (!low && u < u1) {
            h1 += slope * (u - u1);
            u1 = u;
        }
    };
    cut(0, true);
    cut(1, false);
    if (!(u1 > u0)) return false;
    if (slope != 0) // clips the stretch to gaps in [-kRounding, width]
        for (const double h : {-kRounding, width}) {
            const double u = u0 + (h - h0) / slope;
            const bool below = h < 0;
            if (u > u0 && u < u1) cut(u, below == (slope > 0));
        }
    const double middle = (h0 + h1) / 2;
    if (middle < -kRounding || middle > width || (u1 - u0) * l < 1e-4) return false;
    out = {{u0, u1}, {h0, h1}};
    return true;
}

void add_bridge(const Edge& e, const FacingStretch& f, Loops& out) {
    const Vec2 d = e.b - e.a;
    const Vec2 outwards = (-1 / norm(d)) * left_of(d);
    const Vec2 p0 = lerp(e.a, e.b, f.u[0]), p1 = lerp(e.a, e.b, f.u[1]);
    const Vec2 quad[4] = {p0 + (f.gap[0] + kRounding) * outwards, p1 + (f.gap[1] + kRounding) * outwards,
                          p1 - kRounding * outwards, p0 - kRounding * outwards};
    out.add(quad);
}

// Makes a grid whose cells list the edges nearer than `margin`.
geom::SegmentGrid grid_over(const std::vector<Edge>& edges, const Box2& box, double margin) {
    std::vector<geom::Segment> segments;
    double sum = 0;
    for (const Edge& e : edges) {
        segments.push_back({e.a, e.b});
        sum += geom::distance(e.a, e.b);
    }
    const double w = box.hi.x - box.lo.x, h = box.hi.y - box.lo.y, n = static_cast<double>(edges.size());
    // cells are as wide as an edge is long, but there are not many more cells than edges
    const double cell = std::max({sum / n, std::sqrt(w * h / (4 * n)), std::max(w, h) / 4096, 4 * margin, 1e-3});
    return {segments, cell, margin};
}

bool near(const Edge& e, const Edge& f, double margin) {
    return std::min(e.a.x, e.b.x) <= std::max(f.a.x, f.b.x) + margin &&
           std::min(f.a.x, f.b.x) <= std::max(e.a.x, e.b.x) + margin &&
           std::min(e.a.y, e.b.y) <= std::max(f.a.y, f.b.y) + margin &&
           std::min(f.a.y, f.b.y) <= std::max(e.a.y, e.b.y) + margin;
}

// Drops loops with a mean width below `hairline`. A union leaves them where faces nearly coincide.
Loops without_slivers(const Loops& loops, double hairline, std::int64_t layer, Notes& notes) {
    Loops out;
    Note filled{.code = NoteCode::hairline_hole_filled, .amount = 0, .count = 0, .layer = layer};
    Note dropped = filled;
    dropped.code = NoteCode::hairline_sliver_dropped;
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const double area = polygon::signed_area(loops[i]);
        if (2 * std::abs(area) > hairline * polygon::perimeter(loops[i])) { // compares the mean width
            out.add(loops[i]);
            continue;
        }
        if (2 * std::abs(area) <= kRounding * polygon::perimeter(loops[i])) continue; // only rounding
        Note& n = area < 0 ? filled : dropped;
        if (std::abs(area) * static_cast<double>(n.count) >= n.amount) {
            n.x = loops[i][0].x;
            n.y = loops[i][0].y;
        }
        n.amount += std::abs(area);
        ++n.count;
    }
    for (Note* n : {&filled, &dropped})
        if (n->count > 0) notes.push_back(std::move(*n));
    return out;
}

} // namespace

Loops bridges(const Loops& loops, double width, double& gap_area, std::size_t& gaps) {
    gap_area = 0;
    gaps = 0;
    Loops out;
    const auto edges = edges_of(loops);
    if (edges.empty()) return out;
    const geom::SegmentGrid grid = grid_over(edges, polygon::bounds(loops), width);
    std::vector<std::uint64_t> pairs;
    for (std::size_t c = 0; c < grid.cells(); ++c) {
        const auto in = grid.in(c);
        for (std::size_t i = 0; i < in.size(); ++i)
            for (std::size_t j = i + 1; j < in.size(); ++j) {
                const auto &e = edges[in[i]], &f = edges[in[j]];
                if (!near(e, f, width) || neighbours(e, f)) continue;
                if (FacingStretch facing_now; facing(e, f, width, facing_now))
                    pairs.push_back(std::uint64_t{in[i]} << 32 | in[j]);
            }
    }
    std::sort(pairs.begin(), pairs.end()); // two edges may share many cells
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const std::uint64_t pair : pairs) {
        const auto &e = edges[pair >> 32], &f = edges[pair & 0xffffffff];
        FacingStretch between{};
        if (!facing(e, f, width, between)) continue;
        add_bridge(e, between, out);
        const double gap = std::max(0.0, (between.gap[0] + between.gap[1]) / 2);
        if (gap > kRounding) {
            gap_area += gap * (between.u[1] - between.u[0]) * geom::distance(e.a, e.b);
            ++gaps;
        }
    }
    return out;
}

Loops heal_hairlines(Loops loops, bool united, double hairline, std::int64_t layer, Notes& notes) {
    if (!(hairline > 0)) return loops;
    if (united) loops = without_slivers(loops, hairline, layer, notes);
    double area = 0;
    std::size_t gaps = 0;
    const Loops between = bridges(loops, hairline, area, gaps);
    if (gaps > 0)
        notes.push_back({.code = NoteCode::hairline_gap_between_bodies, .amount = area, .count = gaps, .layer = layer});
    if (between.empty()) return loops;
    for (std::size_t l = 0; l < between.size(); ++l) loops.add(between[l]);
    return without_slivers(polygon::unite_exactly(loops), hairline, layer, notes);
}

} // namespace filum::slice
