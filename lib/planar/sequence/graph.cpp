#include "sequence/graph.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace filum::sequence {

Arcs arcs(std::size_t n, std::vector<Pair> pairs) {
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    Arcs out;
    out.start.assign(n + 1, 0);
    out.to.reserve(pairs.size());
    for (const auto& [from, to] : pairs) {
        ++out.start[from + 1];
        out.to.push_back(to);
    }
    for (std::size_t i = 0; i < n; ++i) out.start[i + 1] += out.start[i];
    return out;
}

Arcs reversed(const Arcs& a) {
    const std::size_t n = a.start.size() - 1;
    Arcs out;
    out.start.assign(n + 1, 0);
    for (const Index t : a.to) ++out.start[t + 1];
    for (std::size_t i = 0; i < n; ++i) out.start[i + 1] += out.start[i];
    out.to.resize(a.to.size());
    std::vector<Index> at(out.start.begin(), out.start.end() - 1);
    for (Index i = 0; i < n; ++i)
        for (const Index t : a[i]) out.to[at[t]++] = i;
    return out;
}

namespace {

[[noreturn]] void bad(const polygon::Region& r, const std::string& why) {
    throw Error(Exit::bad_input, "cannot sequence region '" + std::to_string(r.id) + "': " + why);
}

} // namespace

Graph support_graph(std::span<const polygon::Region> regions) {
    Graph g;
    std::vector<Pair> links, support;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const auto& r = regions[i];
        if (r.id != i) bad(r, "its id should be " + std::to_string(i) + "; regions must come straight from 'regions'");
        Index layer = 0;
        if (i > 0) {
            const auto& p = regions[i - 1];
            if (r.layer < p.layer || (r.layer > p.layer && r.z <= p.z) || (r.layer == p.layer && r.z != p.z))
                bad(r, "its layer is out of order");
            layer = g.node.back().layer + (r.layer > p.layer ? 1 : 0);
        }
        g.node.push_back(
            {layer, r.z, polygon::centroid(r.loops), r.tool, r.rests_on() < std::int64_t{regions.front().layer}});
        for (const auto& o : r.below) {
            if (o.below >= i || regions[o.below].layer >= r.layer)
                bad(r, "it rests on a region that is not on a layer below");
            const bool carries = regions[o.below].layer == r.rests_on();
            if (o.link && !carries) bad(r, "its link does not lead to a region of the layer below");
            if (o.link && regions[o.below].tool != r.tool) bad(r, "its link leads to a region of another tool");
            if (o.link) links.emplace_back(o.below, r.id);
            if (!carries) continue;
            support.emplace_back(o.below, r.id);
            g.node.back().carried = true;
        }
    }
    g.up = arcs(g.size(), std::move(links));
    g.down = reversed(g.up);
    g.after = arcs(g.size(), std::move(support));
    g.before = reversed(g.after);
    return g;
}

std::vector<Index> tools(const Graph& g) {
    std::vector<Index> out;
    for (const Node& n : g.node)
        if (const auto at = std::lower_bound(out.begin(), out.end(), n.tool); at == out.end() || *at != n.tool)
            out.insert(at, n.tool);
    return out;
}

std::vector<Pair> carried_from_afar(std::span<const polygon::Region> regions) {
    std::vector<Pair> out;
    for (const auto& r : regions)
        for (const auto& o : r.below)
            if (regions[o.below].layer < r.rests_on()) out.emplace_back(o.below, r.id);
    return out;
}

namespace {

// The number of regions on the longest path from each region along the arcs; `order` must be topological.
template <class Range>
std::vector<Index> longest(const Arcs& arcs, const Range& order) {
    std::vector<Index> out(arcs.start.size() - 1, 1);
    for (const Index v : order)
        for (const Index w : arcs[v]) out[v] = std::max(out[v], out[w] + 1);
    return out;
}

// The one with the least key; kNone if it is not unique.
template <class Key>
Index only_least(std::span<const Index> among, Key&& key) {
    if (among.empty()) return kNone;
    const auto less = [&](Index a, Index b) { return key(a) < key(b); };
    const Index best = *std::min_element(among.begin(), among.end(), less);
    const auto as_good = [&](Index v) { return v != best && key(v) == key(best); };
    return std::any_of(among.begin(), among.end(), as_good) ? kNone : best;
}

} // namespace

Columns columns(const Graph& g, std::span<const std::uint64_t> colour) {
    const Index n = g.size();
    std::vector<Index> up(n);
    std::iota(up.begin(), up.end(), 0U);
    const std::vector<Index> depth = longest(g.before, up);
    const std::vector<Index> height = longest(g.after, std::vector<Index>(up.rbegin(), up.rend()));
    const auto linked = [](const Arcs& links, Index u, Index v) {
        return std::binary_search(links[u].begin(), links[u].end(), v);
    };
    std::vector<Index> below(n, kNone), above(n, kNone);
    std::vector<Index> carrying;
    for (Index v = 0; v < n; ++v) {
        carrying.clear();
        for (const Index u : g.before[v])
            if (g.node[u].tool == g.node[v].tool) carrying.push_back(u);
        below[v] =
            only_least(carrying, [&](Index u) { return std::tuple(!linked(g.up, u, v), n - depth[u], colour[u]); });
    }
    std::vector<Index> carried;
    for (Index u = 0; u < n; ++u) {
        carried.clear();
        for (const Index v : g.after[u])
            if (below[v] == u) carried.push_back(v);
        above[u] =
            only_least(carried, [&](Index v) { return std::tuple(!linked(g.up, u, v), n - height[v], colour[v]); });
    }
    Columns out;
    out.of.assign(n, kNone);
    for (Index v = 0; v < n; ++v) {
        if (below[v] != kNone && above[below[v]] == v) continue;
        for (Index u = v; u != kNone; u = above[u]) {
            if (u == v) out.member.emplace_back();
            out.of[u] = static_cast<Index>(out.member.size() - 1);
            out.member.back().push_back(u);
        }
    }
    return out;
}

void add_precedence(Graph& g, std::vector<Pair> more) {
    for (Index i = 0; i < g.size(); ++i)
        for (const Index t : g.after[i]) more.emplace_back(i, t);
    g.after = arcs(g.size(), std::move(more));
    g.before = reversed(g.after);
}

} // namespace filum::sequence
