#include "surfpath/slits.hpp"

#include "geom/disjoint_sets.hpp"
#include "surface/curve/line.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/rules/rules.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace filum::surfpath {

namespace {

using geom::Vec3;
using surface::kNone;
using surface::Surface;
using surface::curve::Line;

constexpr std::size_t kRoots = 8; // number of base points through which loops are searched, far from each other

// A component without boundary: its vertices and its genus.
struct ClosedComponent {
    std::vector<std::uint32_t> vertices;
    std::size_t handles = 0;
};

// The components without rim and source.
std::vector<ClosedComponent> closed_components(const surface::Sheet& sheet) {
    const Surface& s = sheet.surface;
    std::vector<char> open(s.components, 0);
    for (const auto& rim : s.rims) open[rim.component] = 1;
    for (const auto& g : sheet.sources.segments) open[s.component[g.triangle]] = 1;
    for (const std::uint32_t v : sheet.sources.vertices) open[s.component[s.outgoing[v] / 3]] = 1;
    std::vector<std::vector<std::uint32_t>> vertices(s.components);
    std::vector<std::size_t> triangles(s.components, 0);
    for (const std::uint32_t c : s.component) ++triangles[c];
    for (std::uint32_t v = 0; v < s.vertices.size(); ++v) vertices[s.component[s.outgoing[v] / 3]].push_back(v);
    std::vector<ClosedComponent> out;
    for (std::uint32_t c = 0; c < s.components; ++c) {
        if (open[c] != 0) continue;
        // A closed surface has 3/2 edges per triangle; by Euler, vertices - edges + triangles = 2 - 2 handles.
        const std::size_t handles = (2 + triangles[c] / 2 - vertices[c].size()) / 2;
        out.push_back({std::move(vertices[c]), handles});
    }
    return out;
}

// Shortest paths along edges from the nearest of several roots (Dijkstra).
struct ShortestPathTree {
    std::vector<double> length; // per vertex, mm
    // per vertex: the half-edge that leads to it; kNone at roots and where no path leads
    std::vector<std::uint32_t> before;
};

ShortestPathTree ways(const Surface& s, const std::vector<std::uint32_t>& roots) {
    ShortestPathTree out{std::vector<double>(s.vertices.size(), std::numeric_limits<double>::infinity()),
                         std::vector<std::uint32_t>(s.vertices.size(), kNone)};
    using Item = std::tuple<double, std::uint32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> front;
    for (const std::uint32_t v : roots) {
        out.length[v] = 0;
        front.emplace(0.0, v);
    }
    while (!front.empty()) {
        const double length = std::get<0>(front.top());
        const std::uint32_t v = std::get<1>(front.top());
        front.pop();
        if (length > out.length[v]) continue;
        surface::each_outgoing(s, v, [&](std::uint32_t h) {
            const double on = length + surface::side_length(s, h);
            if (!(on < out.length[s.head(h)])) return;
            out.length[s.head(h)] = on;
            out.before[s.head(h)] = h;
            front.emplace(on, s.head(h));
        });
    }
    return out;
}

std::uint32_t farthest(const ClosedComponent& c, const ShortestPathTree& w) {
    return *std::max_element(c.vertices.begin(), c.vertices.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return w.length[a] < w.length[b]; });
}

// The vertices on the path from the root to `v`.
std::vector<std::uint32_t> way_to(const Surface& s, const ShortestPathTree& w, std::uint32_t v) {
    std::vector<std::uint32_t> out{v};
    while (w.before[out.back()] != kNone) out.push_back(s.tail(w.before[out.back()]));
    std::reverse(out.begin(), out.end());
    return out;
}

Line through(const Surface& s, const std::vector<std::uint32_t>& vertices, bool closed) {
    Line out{{}, closed};
    for (const std::uint32_t v : vertices) out.places.push_back({s.outgoing[v] / 3, s.vertices[v]});
    return out;
}

struct VertexLoop {
    double length = std::numeric_limits<double>::infinity(); // mm, along edges
    std::vector<std::uint32_t> vertices;
};

// A short loop through `root` that does not separate the surface: a shortest path, one edge, and a shortest path back.
// A spanning tree of the triangles crosses as many as possible of the edges outside the shortest path tree, those of
// the longest loops first. Every edge that remains closes a loop that does not separate the surface, because the
// triangles on its two sides are connected through the tree; the last one is the shortest (Erickson, Whittlesey 2005).
VertexLoop loop(const Surface& s, std::uint32_t root, std::uint32_t component) {
    const ShortestPathTree w = ways(s, {root});
    std::vector<std::tuple<double, std::uint32_t>> edges; // with the length of the loop that each closes
    for (std::uint32_t h = 0; h < s.twin.size(); ++h)
        if (s.component[h / 3] == component && h < s.twin[h] && w.before[s.head(h)] != h &&
            w.before[s.tail(h)] != s.twin[h])
            edges.emplace_back(w.length[s.tail(h)] + surface::side_length(s, h) + w.length[s.head(h)], h);
    std::sort(edges.begin(), edges.end(), std::greater<>());
    geom::DisjointSets triangles(s.triangles.size());
    VertexLoop out;
    std::uint32_t last = kNone;
    for (const auto& [length, h] : edges)
        if (!triangles.unite(h / 3, s.twin[h] / 3)) {
            out.length = length;
            last = h;
        }
    if (last == kNone) return out;
    out.vertices = way_to(s, w, s.tail(last));
    auto back = way_to(s, w, s.head(last));
    std::size_t common = 0; // both paths begin at the root
    while (common + 1 < std::min(back.size(), out.vertices.size()) && back[common + 1] == out.vertices[common + 1])
        ++common;
    out.vertices.erase(out.vertices.begin(), out.vertices.begin() + static_cast<std::ptrdiff_t>(common));
    out.vertices.insert(out.vertices.end(), back.rbegin(), back.rend() - static_cast<std::ptrdiff_t>(common + 1));
    return out;
}

// Pulls a line straight on the surface: points of even, then of odd index move to the middle of their neighbours. The
// ends of an open line stay.
Line straightened(const Surface& s, Line line) {
    const std::size_t n = line.size(), first = line.closed ? 0 : 1, last = line.closed ? n : n - 1;
    const double rest = rules::kRest * surface::mean_edge(s);
    double moved = 2 * rest;
    for (int round = 0; round < rules::kMostSweeps && moved > rest; ++round) {
        moved = 0;
        for (std::size_t odd = 0; odd < 2; ++odd)
            for (std::size_t i = first + odd; i < last; i += 2) {
                const Vec3 middle = 0.5 * (line[(i + n - 1) % n] + line[(i + 1) % n]);
                const auto to = surface::curve::step(s, line.places[i], middle - line[i]);
                moved = std::max(moved, distance(to.point, line[i]));
                line.places[i] = to;
            }
    }
    return line;
}

void add(const Surface& s, const Line& straight, surface::Sources& to, Notes& notes) {
    const Line line = surface::curve::threaded(s, straight);
    const std::size_t n = line.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < n; ++i) {
        const auto& from = line.places[i];
        if (surface::curve::lies_in(s, from.triangle, line[(i + 1) % n]))
            to.segments.push_back({from.triangle, from.point, line[(i + 1) % n]});
    }
    const Vec3 at = line[n / 2];
    notes.push_back({NoteCode::surface_opened, surface::curve::length(line), 1, -1, at.x, at.y, at.z});
}

} // namespace

surface::Sources slits(const surface::Sheet& sheet, Notes& notes) {
    const Surface& s = sheet.surface;
    surface::Sources out;
    for (const ClosedComponent& c : closed_components(sheet)) {
        const std::uint32_t one = farthest(c, ways(s, {c.vertices[0]}));
        if (c.handles == 0) {
            const ShortestPathTree w = ways(s, {one});
            add(s, straightened(s, through(s, way_to(s, w, farthest(c, w)), false)), out, notes);
            continue;
        }
        std::vector<std::uint32_t> roots{one};
        VertexLoop best;
        for (std::size_t k = 0; k < kRoots; ++k) {
            VertexLoop found = loop(s, roots.back(), s.component[s.outgoing[one] / 3]);
            if (found.length < best.length) best = std::move(found);
            roots.push_back(farthest(c, ways(s, roots)));
        }
        add(s, straightened(s, through(s, best.vertices, true)), out, notes);
    }
    return out;
}

} // namespace filum::surfpath
