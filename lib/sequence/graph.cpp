#include "sequence/graph.hpp"

#include "base/error.hpp"

#include <algorithm>

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

Graph support_graph(std::span<const polygon::Region> regions, double least_area) {
    Graph g;
    std::vector<Pair> links, support;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        const auto& r = regions[i];
        if (r.id != i) bad(r, "its id is not " + std::to_string(i) + "; regions must come straight from 'regions'");
        Index layer = 0;
        if (i > 0) {
            const auto& p = regions[i - 1];
            if (r.layer < p.layer || (r.layer > p.layer && r.z <= p.z) || (r.layer == p.layer && r.z != p.z))
                bad(r, "its layer is out of order");
            layer = g.node.back().layer + (r.layer > p.layer ? 1 : 0);
        }
        g.node.push_back({layer, r.z, geom::lerp(r.box.lo, r.box.hi, 0.5)});
        for (const auto& o : r.below) {
            if (o.below >= i || regions[o.below].layer + 1 != r.layer)
                bad(r, "it overlaps no region of the layer below");
            if (o.link) links.emplace_back(o.below, r.id);
            if (o.link || o.area >= least_area) support.emplace_back(o.below, r.id);
        }
    }
    g.up = arcs(g.size(), std::move(links));
    g.down = reversed(g.up);
    g.after = arcs(g.size(), std::move(support));
    g.before = reversed(g.after);
    return g;
}

Columns columns(std::span<const polygon::Region> regions, double least_area) {
    const auto n = static_cast<Index>(regions.size());
    std::vector<Index> below(n, kNone), above(n, kNone);
    std::vector<double> share(n, 0);
    for (Index v = 0; v < n; ++v) {
        double most = 0;
        for (const auto& o : regions[v].below)
            if ((o.link || o.area >= least_area) && o.area > most) most = o.area, below[v] = o.below;
        const Index u = below[v];
        if (u == kNone) continue;
        if (most > share[u]) share[u] = most, above[u] = v;
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
