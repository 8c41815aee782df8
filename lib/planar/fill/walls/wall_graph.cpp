#include "fill/walls/wall_graph.hpp"

#include "base/none.hpp"
#include "fill/rings/fewer_points.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/walls/thin_edges.hpp"
#include "geom/polyline.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <queue>

namespace filum::fill::walls {

namespace {

// Divides tapers, and gives beads a least width where tips taper to nothing.
void make_beads(WallGraph& g, double width) {
    const double least = rings::kLeastVoid * width * width;
    for (Wall& w : g.walls) {
        toolpath::Curve out;
        for (std::size_t i = 0; i < w.line.points.size(); ++i)
            rings::add_tapered(w.line.points[i], w.line.width[i], least, out);
        for (double& wide : out.width) wide = std::max(wide, rings::kNarrowest * width);
        w.line = std::move(out);
    }
}

// Follows the axis from node to node.
class Tracer {
  public:
    Tracer(const polygon::MedialAxis& axis, const std::vector<std::uint32_t>& edges)
        : axis_(axis), at_(axis.nodes()), node_(axis.nodes(), kNone), done_(axis.half_edges() / 2, 1) {
        for (const auto k : edges) {
            at_[axis.from[2 * k]].push_back(k);
            at_[axis.to(2 * k)].push_back(k);
            done_[k] = 0;
        }
    }

    WallGraph run() {
        for (std::uint32_t v = 0; v < at_.size(); ++v)
            if (!at_[v].empty() && at_[v].size() != 2) add_node(v);
        for (std::uint32_t v = 0; v < at_.size(); ++v) follow_from(v);
        for (std::uint32_t v = 0; v < at_.size(); ++v) { // rings without a node
            const bool left = std::any_of(at_[v].begin(), at_[v].end(), [&](auto k) { return done_[k] == 0; });
            if (left) {
                add_node(v);
                follow_from(v);
            }
        }
        return std::move(out_);
    }

  private:
    void add_node(std::uint32_t v) {
        node_[v] = static_cast<std::uint32_t>(out_.node.size());
        out_.node.push_back(axis_.node[v]);
    }
    void follow_from(std::uint32_t v) {
        if (node_[v] == kNone) return;
        for (const auto k : at_[v])
            if (done_[k] == 0) follow(v, k);
    }
    void follow(std::uint32_t v, std::uint32_t k) {
        Wall w;
        w.a = node_[v];
        w.line.add(axis_.node[v], 2 * axis_.radius[v]);
        for (;;) {
            done_[k] = 1;
            v = axis_.from[2 * k] == v ? axis_.to(2 * k) : axis_.from[2 * k];
            w.line.add(axis_.node[v], 2 * axis_.radius[v]);
            if (node_[v] != kNone) break;
            k = at_[v][0] == k ? at_[v][1] : at_[v][0];
        }
        w.b = node_[v];
        w.length = geom::length(w.line.points);
        out_.walls.push_back(std::move(w));
    }

    const polygon::MedialAxis& axis_;
    std::vector<std::vector<std::uint32_t>> at_;
    std::vector<std::uint32_t> node_;
    std::vector<char> done_;
    WallGraph out_;
};

// Shortest ways from one node to all: length, and the wall that leads to each.
struct Ways {
    std::vector<double> length;
    std::vector<std::uint32_t> by;
};

Ways ways(const WallGraph& g, const std::vector<std::vector<std::uint32_t>>& at, std::uint32_t from) {
    Ways out{std::vector<double>(g.node.size(), std::numeric_limits<double>::infinity()),
             std::vector<std::uint32_t>(g.node.size(), kNone)};
    using Item = std::pair<double, std::uint32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    out.length[from] = 0;
    queue.emplace(0, from);
    while (!queue.empty()) {
        const auto [l, v] = queue.top();
        queue.pop();
        if (l > out.length[v]) continue;
        for (const auto k : at[v]) {
            const auto u = g.walls[k].a == v ? g.walls[k].b : g.walls[k].a;
            if (l + g.walls[k].length >= out.length[u]) continue;
            out.length[u] = l + g.walls[k].length;
            out.by[u] = k;
            queue.emplace(out.length[u], u);
        }
    }
    return out;
}

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

// Pairs up 0 .. n - 1 (n even): the nearest two first. Then two pairs exchange partners while that helps.
Pairs matched(std::size_t n, const std::vector<std::vector<double>>& cost) {
    std::vector<char> taken(n, 0);
    Pairs all, out;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j) all.emplace_back(i, j);
    std::stable_sort(all.begin(), all.end(),
                     [&](const auto& p, const auto& q) { return cost[p.first][p.second] < cost[q.first][q.second]; });
    for (const auto& [i, j] : all)
        if (taken[i] == 0 && taken[j] == 0) {
            taken[i] = taken[j] = 1;
            out.emplace_back(i, j);
        }
    const auto sum = [&](const auto& p, const auto& q) { return cost[p.first][p.second] + cost[q.first][q.second]; };
    for (bool better = true; better;) {
        better = false;
        for (auto& p : out)
            for (auto& q : out) {
                if (&p == &q) continue;
                for (std::size_t* other : {&q.first, &q.second}) {
                    const double now = sum(p, q);
                    std::swap(p.second, *other);
                    if (sum(p, q) < now - 1e-9)
                        better = true;
                    else
                        std::swap(p.second, *other);
                }
            }
    }
    return out;
}

std::uint32_t other_end(const Wall& w, std::uint32_t v) { return w.a == v ? w.b : w.a; }

// Lets the trail begin at one odd node and end at another. Chooses the way between two nodes of `odd` that saves the
// most length when its walls change between one and two passes. Exact in a tree, where there is only one way.
void open_up(const WallGraph& g, const std::vector<std::vector<std::uint32_t>>& at,
             const std::vector<std::uint32_t>& odd, std::vector<int>& passes) {
    WallGraph priced{g.node, g.walls}; // walls that are passed twice cost nothing
    for (std::size_t k = 0; k < g.walls.size(); ++k)
        if (passes[k] == 2) priced.walls[k].length = 0;
    double most = 0;
    std::vector<std::uint32_t> best;
    for (const auto from : odd) {
        const Ways w = ways(priced, at, from);
        for (const auto to : odd) {
            if (to <= from) continue;
            double saved = 0;
            std::vector<std::uint32_t> way;
            for (auto v = to; v != from; v = other_end(g.walls[way.back()], v)) {
                way.push_back(w.by[v]);
                saved += (passes[way.back()] == 2 ? 1 : -1) * g.walls[way.back()].length;
            }
            if (saved > most) {
                most = saved;
                best = way;
            }
        }
    }
    for (const auto k : best) passes[k] = 3 - passes[k];
}

} // namespace

std::optional<WallGraph> wall_graph(const Loops& area, double width) {
    // half-thickness up to which the width of one bead is, as a ratio, nearer to the usual one than that of two
    const double most = width / std::numbers::sqrt2;
    if (!polygon::offset(area, -most).empty()) return std::nullopt;
    const polygon::MedialAxis axis = axis_for(area, width);
    const auto edges = thin_edges(axis, width, 2 * most); // all except twigs: the offset is inexact at arcs
    if (edges.empty()) return std::nullopt;
    WallGraph out = Tracer(axis, edges).run();
    make_beads(out, width);
    return out;
}

WallGraph thin_walls(const Loops& area, double width) {
    const polygon::MedialAxis axis = split_at(axis_for(area, width), width / 2);
    WallGraph out = Tracer(axis, thin_edges(axis, width, width / 2)).run();
    make_beads(out, width);
    return out;
}

std::vector<int> passes_of_walls(const WallGraph& g) {
    std::vector<std::vector<std::uint32_t>> at(g.node.size());
    for (std::uint32_t k = 0; k < g.walls.size(); ++k) {
        at[g.walls[k].a].push_back(k);
        at[g.walls[k].b].push_back(k);
    }
    std::vector<std::uint32_t> odd;
    for (std::uint32_t v = 0; v < at.size(); ++v)
        if (at[v].size() % 2 != 0) odd.push_back(v);
    std::vector<int> out(g.walls.size(), 1);
    if (odd.size() <= 2) return out;
    std::vector<Ways> from;
    std::vector<std::vector<double>> cost;
    for (const auto v : odd) {
        from.push_back(ways(g, at, v));
        cost.emplace_back();
        for (const auto u : odd) cost.back().push_back(from.back().length[u]);
    }
    for (const auto& [i, j] : matched(odd.size(), cost))
        for (std::uint32_t v = odd[j]; v != odd[i];) {
            const std::uint32_t k = from[i].by[v];
            out[k] = 3 - out[k];
            v = other_end(g.walls[k], v);
        }
    open_up(g, at, odd, out);
    return out;
}

} // namespace filum::fill::walls
