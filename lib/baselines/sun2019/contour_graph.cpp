#include "baselines/sun2019/contour_graph.hpp"

#include "fill/inset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

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

struct Sample {
    std::int64_t column, row; // of a grid with cells as wide as the reach
    int ring;
    std::uint32_t vertex;
    Vec2 p;
};

std::vector<Sample> binned(const std::vector<Ring>& rings, double cell) {
    std::vector<Sample> out;
    for (std::size_t i = 0; i < rings.size(); ++i)
        for (std::size_t k = 0; k < rings[i].size(); ++k) {
            const Vec2 p = rings[i][k];
            out.push_back({static_cast<std::int64_t>(std::floor(p.x / cell)),
                           static_cast<std::int64_t>(std::floor(p.y / cell)), static_cast<int>(i),
                           static_cast<std::uint32_t>(k), p});
        }
    std::sort(out.begin(), out.end(), [](const Sample& a, const Sample& b) {
        return std::tie(a.column, a.row, a.ring, a.vertex) < std::tie(b.column, b.row, b.ring, b.vertex);
    });
    return out;
}

} // namespace

std::vector<Ring> contours(const polygon::Loops& region, const SpiralOptions& o) {
    std::vector<Ring> out;
    double by = o.first * o.offset;
    for (polygon::Loops loops = region; true; by = o.offset) {
        loops = fill::inset(loops, by);
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
    const auto samples = binned(rings, reach);
    std::map<std::pair<int, int>, Edge> nearest;
    const auto before = [](const Sample& s, std::pair<std::int64_t, std::int64_t> cell) {
        return std::pair{s.column, s.row} < cell;
    };
    std::array<std::size_t, 3> from{}; // the samples ascend, so each column's first candidate only moves on
    for (const Sample& s : samples)
        for (int column = -1; column <= 1; ++column) {
            auto& first = from[static_cast<std::size_t>(column + 1)];
            while (first < samples.size() && before(samples[first], {s.column + column, s.row - 1})) ++first;
            for (std::size_t k = first; k < samples.size(); ++k) {
                const Sample& t = samples[k];
                if (t.column != s.column + column || t.row > s.row + 1) break;
                if (t.ring <= s.ring) continue;
                const double d = geom::distance(s.p, t.p);
                if (d > reach) continue;
                const Edge found{s.ring, t.ring, d, s.vertex, t.vertex};
                const auto [at, fresh] = nearest.try_emplace({s.ring, t.ring}, found);
                if (!fresh && d < at->second.distance) at->second = found;
            }
        }
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
                out[child].parent = static_cast<int>(n), out[child].start = e.vertex_b;
                out[n].children.push_back(e.b);
                stack.push_back(child);
            }
            std::sort(out[n].children.begin(), out[n].children.end());
        }
    }
    return out;
}

} // namespace filum::baselines::sun2019
