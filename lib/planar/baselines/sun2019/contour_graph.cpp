#include "baselines/sun2019/contour_graph.hpp"

#include "geom/point_grid.hpp"
#include "polygon/inset.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace filum::baselines::sun2019 {

using geom::Vec2;

namespace {

Ring sampled(std::span<const Vec2> loop, double step) {
    Ring out;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
        const int parts = std::max(1, static_cast<int>(std::ceil(geom::distance(a, b) / step)));
        for (int k = 0; k < parts; ++k) out.push_back(geom::lerp(a, b, static_cast<double>(k) / parts));
    }
    return out;
}

struct ContourSample {
    int ring;
    std::uint32_t vertex;
};

} // namespace

std::vector<Ring> contours(const polygon::Loops& region, const SpiralOptions& o) {
    std::vector<Ring> out;
    double by = o.first * o.offset;
    for (polygon::Loops loops = region; true; by = o.offset) {
        loops = polygon::inset(loops, by);
        if (loops.empty()) return out;
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t i = 0; i < loops.size(); ++i) order.emplace_back(-polygon::signed_area(loops[i]), i);
        std::sort(order.begin(), order.end());
        for (const auto& [area, i] : order) {
            out.push_back(sampled(loops[i], o.sample * o.offset));
            if (area > 0) std::reverse(out.back().begin(), out.back().end());
        }
    }
}

std::vector<Edge> adjacency(const std::vector<Ring>& rings, double reach) {
    std::vector<ContourSample> samples;
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < rings.size(); ++i)
        for (std::size_t k = 0; k < rings[i].size(); ++k) {
            samples.push_back({static_cast<int>(i), static_cast<std::uint32_t>(k)});
            points.push_back(rings[i][k]);
        }
    const geom::PointGrid<Vec2> grid(points, reach);
    std::map<std::pair<int, int>, Edge> nearest;
    grid.each([&](std::uint32_t s) {
        grid.near(points[s], 1, [&](std::uint32_t t) {
            if (samples[t].ring <= samples[s].ring) return;
            const double d = geom::distance(points[s], points[t]);
            if (d > reach) return;
            const Edge found{samples[s].ring, samples[t].ring, d, samples[s].vertex, samples[t].vertex};
            const auto [at, fresh] = nearest.try_emplace({found.a, found.b}, found);
            if (!fresh && d < at->second.distance) at->second = found;
        });
    });
    std::vector<Edge> out;
    for (const auto& [pair, edge] : nearest) out.push_back(edge);
    return out;
}

std::vector<Edge> reverse_delete(std::size_t contours, std::vector<Edge> edges, std::size_t* steps) {
    std::vector<std::vector<std::uint32_t>> at(contours); // the edges of each contour
    for (std::uint32_t e = 0; e < edges.size(); ++e)
        for (const int end : {edges[e].a, edges[e].b}) at[static_cast<std::size_t>(end)].push_back(e);
    std::vector<char> gone(edges.size(), 0);
    std::vector<std::uint32_t> seen(contours, 0);
    std::vector<int> stack;
    std::size_t looked = 0;
    const auto connected = [&](int from, int to, std::uint32_t round) {
        stack.assign(1, from);
        seen[static_cast<std::size_t>(from)] = round;
        while (!stack.empty()) {
            const int n = stack.back();
            stack.pop_back();
            if (n == to) return true;
            for (const std::uint32_t e : at[static_cast<std::size_t>(n)]) {
                ++looked;
                const int other = edges[e].a + edges[e].b - n;
                if (gone[e] || seen[static_cast<std::size_t>(other)] == round) continue;
                seen[static_cast<std::size_t>(other)] = round;
                stack.push_back(other);
            }
        }
        return false;
    };
    for (std::size_t e = edges.size(); e-- > 0;) {
        gone[e] = 1;
        if (!connected(edges[e].a, edges[e].b, static_cast<std::uint32_t>(e) + 1)) gone[e] = 0;
    }
    if (steps != nullptr) *steps = looked;
    std::vector<Edge> out;
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (!gone[e]) out.push_back(edges[e]);
    return out;
}

std::vector<Node> tree(std::size_t contours, const std::vector<Edge>& edges) {
    std::vector<std::vector<Edge>> kept(contours);
    for (const Edge& e : reverse_delete(contours, edges)) {
        kept[static_cast<std::size_t>(e.a)].push_back(e);
        kept[static_cast<std::size_t>(e.b)].push_back({e.b, e.a, e.distance, e.vertex_b, e.vertex_a});
    }
    std::vector<Node> out(contours);
    std::vector<char> seen(contours, 0);
    for (std::size_t root = 0; root < contours; ++root) {
        if (seen[root]) continue;
        seen[root] = 1;
        std::vector<std::size_t> stack{root};
        while (!stack.empty()) {
            const std::size_t n = stack.back();
            stack.pop_back();
            for (const Edge& e : kept[n]) {
                const auto child = static_cast<std::size_t>(e.b);
                if (seen[child]) continue;
                seen[child] = 1;
                out[child].parent = static_cast<int>(n);
                out[child].start = e.vertex_b;
                out[n].children.push_back(e.b);
                stack.push_back(child);
            }
            std::sort(out[n].children.begin(), out[n].children.end());
        }
    }
    return out;
}

} // namespace filum::baselines::sun2019
