#include "sequence/arrange.hpp"

#include "geom/nearest_points.hpp"

#include <algorithm>

namespace filum::sequence {

namespace {

// The strokes of an order: stroke s consists of order[first[s]] to order[first[s + 1] - 1].
struct Strokes {
    std::vector<Index> first, of; // the stroke of each node
};

Strokes strokes_of(const Graph& g, std::span<const Index> order) {
    Strokes out;
    out.of.resize(g.size());
    for (Index i = 0; i < order.size(); ++i) {
        if (i == 0 || !continues(g, order[i - 1], order[i])) out.first.push_back(i);
        out.of[order[i]] = static_cast<Index>(out.first.size() - 1);
    }
    out.first.push_back(static_cast<Index>(order.size()));
    return out;
}

// The strokes that must follow each stroke, and the number of strokes that each follows.
struct StrokePrecedence {
    Arcs after;
    std::vector<Index> waiting;
};

StrokePrecedence precedence(const Graph& g, const Strokes& s) {
    std::vector<Pair> pairs;
    for (Index u = 0; u < g.size(); ++u)
        for (const Index v : g.after[u])
            if (s.of[u] != s.of[v]) pairs.emplace_back(s.of[u], s.of[v]);
    StrokePrecedence out{arcs(s.first.size() - 1, std::move(pairs)), {}};
    out.waiting.assign(s.first.size() - 1, 0);
    for (const Index v : out.after.to) ++out.waiting[v];
    return out;
}

} // namespace

Order arranged(const Graph& g, Order order) {
    if (order.empty()) return order;
    const Strokes s = strokes_of(g, order);
    StrokePrecedence p = precedence(g, s);
    const auto n = static_cast<Index>(p.waiting.size());
    std::vector<Index> by_id(n), number(n); // so that ties go to the lower id of the first region
    for (Index i = 0; i < n; ++i) by_id[i] = i;
    std::sort(by_id.begin(), by_id.end(), [&](Index a, Index b) { return order[s.first[a]] < order[s.first[b]]; });
    std::vector<geom::Vec2> start;
    for (Index i = 0; i < n; ++i) {
        number[by_id[i]] = i;
        start.push_back(g.node[order[s.first[by_id[i]]]].centre);
    }
    geom::NearestPoints ready(start);
    for (Index i = 0; i < n; ++i)
        if (p.waiting[i] == 0) ready.insert(number[i]);
    Order out;
    const auto first = std::find_if(by_id.begin(), by_id.end(), [&](Index i) { return p.waiting[i] == 0; });
    for (auto next = number[*first];; next = *ready.nearest(g.node[out.back()].centre)) {
        const Index i = by_id[next];
        ready.remove(next);
        out.insert(out.end(), order.begin() + s.first[i], order.begin() + s.first[i + 1]);
        for (const Index j : p.after[i])
            if (--p.waiting[j] == 0) ready.insert(number[j]);
        if (ready.empty()) break;
    }
    return cost(g, out) < cost(g, order) ? out : order;
}

} // namespace filum::sequence
