#include "sequence/windows.hpp"

#include "sequence/matching.hpp"
#include "sequence/order.hpp"

#include <algorithm>
#include <map>

namespace filum::sequence {

namespace {

// Region at place `from` of one column precedes that at place `to` of another.
struct Step {
    Index from, to;
};

// Stretches of columns, each from its column's current place up to `end`.
struct Window {
    std::vector<Index> column, end;
};

struct Packing {
    const Graph& g;
    const Columns& columns;
    std::map<Pair, std::vector<Step>> steps; // per pair of columns, ascending
    std::vector<std::vector<Index>> rivals;  // per column: those with steps both ways
    std::vector<Index> at;                   // per column: links below this place are taken
    std::vector<char> taken;                 // per region: the link up its column is in a window
    Index links = 0, broken = 0;             // in windows; and how many of them no order uses

    [[nodiscard]] Index layer(Index c, Index place) const { return g.node[columns.member[c][place]].layer; }
    void gather(const std::vector<Pair>& collisions);
    [[nodiscard]] Index end(Index a, Index b) const;
    [[nodiscard]] Window lowest_pair() const;
    [[nodiscard]] Window grown(const Window& w) const;
    [[nodiscard]] double size(const Window& w) const;
    void take(const Window& w);
};

void Packing::gather(const std::vector<Pair>& collisions) {
    const auto place = [&](Index v) { return g.node[v].layer - layer(columns.of[v], 0); };
    for (const auto& [v, u] : collisions) steps[{columns.of[v], columns.of[u]}].push_back({place(v), place(u)});
    for (auto& [pair, s] : steps) std::sort(s.begin(), s.end(), [](Step a, Step b) { return a.from < b.from; });
    rivals.resize(columns.member.size());
    for (const auto& [pair, s] : steps)
        if (steps.count({pair.second, pair.first}) != 0) rivals[pair.first].push_back(pair.second);
    at.assign(columns.member.size(), 0);
    taken.assign(g.size(), 0);
}

// Where a's stretch must end so that its head follows b's foot; kNone if there is no such place.
Index Packing::end(Index a, Index b) const {
    const auto& s = steps.at({b, a});
    const auto it = std::lower_bound(s.begin(), s.end(), at[b], [](const Step& x, Index f) { return x.from < f; });
    return it == s.end() || it->to <= at[a] ? kNone : it->to;
}

double Packing::size(const Window& w) const {
    double sum = 0;
    for (std::size_t i = 0; i < w.column.size(); ++i) sum += w.end[i] - at[w.column[i]];
    return sum;
}

Window Packing::lowest_pair() const {
    Window best;
    Index lowest = kNone;
    for (Index a = 0; a < rivals.size(); ++a)
        for (const Index b : rivals[a]) {
            if (b < a) continue;
            const Index ea = end(a, b), eb = end(b, a);
            if (ea == kNone || eb == kNone) continue;
            const Index top = std::max(layer(a, ea), layer(b, eb));
            if (top < lowest) lowest = top, best = {{a, b}, {ea, eb}};
        }
    return best;
}

// `w` with the one more column that makes it least larger; empty if none fits.
Window Packing::grown(const Window& w) const {
    Window best;
    double least = 0;
    for (const Index c : rivals[w.column[0]]) {
        if (std::find(w.column.begin(), w.column.end(), c) != w.column.end()) continue;
        Window v = w;
        Index own = 0;
        for (std::size_t i = 0; i < w.column.size() && own != kNone; ++i) {
            const Index d = w.column[i];
            const bool rival = std::binary_search(rivals[c].begin(), rivals[c].end(), d);
            const Index ec = rival ? end(c, d) : kNone, ed = rival ? end(d, c) : kNone;
            if (ec == kNone || ed == kNone)
                own = kNone;
            else
                own = std::max(own, ec), v.end[i] = std::max(v.end[i], ed);
        }
        if (own == kNone) continue;
        v.column.push_back(c);
        v.end.push_back(own);
        if (const double s = size(v); best.column.empty() || s < least) least = s, best = std::move(v);
    }
    return best;
}

void Packing::take(const Window& w) {
    Index whole = 0; // stretches that are links all the way; a step that is no link is a break already
    for (std::size_t i = 0; i < w.column.size(); ++i) {
        const auto& member = columns.member[w.column[i]];
        bool unbroken = true;
        for (Index p = at[w.column[i]]; p < w.end[i]; ++p) {
            taken[member[p]] = 1;
            if (continues(g, member[p], member[p + 1]))
                ++links;
            else
                unbroken = false;
        }
        if (unbroken) ++whole;
        at[w.column[i]] = w.end[i];
    }
    broken += whole > 0 ? whole - 1 : 0;
}

} // namespace

Index window_bound(const Graph& g, const Columns& columns, const std::vector<Pair>& collisions) {
    Packing p{g, columns, {}, {}, {}, {}};
    p.gather(collisions);
    for (Window w = p.lowest_pair(); !w.column.empty(); w = p.lowest_pair()) {
        Window best = w;
        for (w = p.grown(w); !w.column.empty(); w = p.grown(w))
            if (static_cast<double>(w.column.size() - 1) * p.size(best) >
                static_cast<double>(best.column.size() - 1) * p.size(w))
                best = w;
        p.take(best);
    }
    std::vector<Pair> rest;
    for (Index u = 0; u < g.size(); ++u)
        for (const Index v : g.up[u])
            if (p.taken[u] == 0 || columns.of[v] != columns.of[u]) rest.emplace_back(u, v);
    return g.size() - matched(maximum_matching(arcs(g.size(), std::move(rest)))) - (p.links - p.broken);
}

} // namespace filum::sequence
