#include "sequence/windows.hpp"

#include "sequence/matching.hpp"
#include "sequence/order.hpp"

#include <algorithm>
#include <map>

namespace filum::sequence {

namespace {

constexpr std::size_t kMostColumns = 48;        // in a window: more gain little, (k - 1) / k
constexpr std::uint64_t kMostWork = 10'000'000; // ends looked up; what was packed until then counts

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
    // per column: those with steps both ways, ascending, and the steps from them to it
    std::vector<std::vector<std::pair<Index, const std::vector<Step>*>>> rivals;
    std::vector<Index> at;       // per column: links below this place are taken
    std::vector<char> taken;     // per region: the link up its column is in a window
    Index links = 0, broken = 0; // in windows; and how many of them no order uses
    mutable std::uint64_t work = 0;

    [[nodiscard]] Index layer(Index c, Index place) const { return g.node[columns.member[c][place]].layer; }
    void gather(const std::vector<Pair>& collisions);
    [[nodiscard]] Index end(Index a, const std::vector<Step>& from_b, Index b) const;
    [[nodiscard]] Index end(Index a, Index b) const;
    [[nodiscard]] Window lowest_pair() const;
    [[nodiscard]] Window grown(const Window& w) const;
    [[nodiscard]] double size(const Window& w) const;
    void leave_below(const Window& pair);
    void take(const Window& w);
};

void Packing::gather(const std::vector<Pair>& collisions) {
    const auto place = [&](Index v) { return g.node[v].layer - layer(columns.of[v], 0); };
    for (const auto& [v, u] : collisions) steps[{columns.of[v], columns.of[u]}].push_back({place(v), place(u)});
    for (auto& [pair, s] : steps) std::sort(s.begin(), s.end(), [](Step a, Step b) { return a.from < b.from; });
    rivals.resize(columns.member.size());
    for (const auto& [pair, s] : steps)
        if (const auto back = steps.find({pair.second, pair.first}); back != steps.end())
            rivals[pair.first].emplace_back(pair.second, &back->second);
    at.assign(columns.member.size(), 0);
    taken.assign(g.size(), 0);
}

// Where a's stretch must end so that its head follows b's foot; kNone if there is no such place.
Index Packing::end(Index a, const std::vector<Step>& from_b, Index b) const {
    ++work;
    const auto it =
        std::lower_bound(from_b.begin(), from_b.end(), at[b], [](const Step& x, Index f) { return x.from < f; });
    return it == from_b.end() || it->to <= at[a] ? kNone : it->to;
}

Index Packing::end(Index a, Index b) const {
    const auto& r = rivals[a];
    const auto it = std::lower_bound(r.begin(), r.end(), b, [](const auto& x, Index c) { return x.first < c; });
    return it == r.end() || it->first != b ? kNone : end(a, *it->second, b);
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
        for (const auto& [b, steps_to_a] : rivals[a]) {
            if (b < a) continue;
            const Index ea = end(a, *steps_to_a, b), eb = ea == kNone ? kNone : end(b, a);
            if (eb == kNone) continue;
            const Index top = std::max(layer(a, ea), layer(b, eb));
            if (top < lowest) lowest = top, best = {{a, b}, {ea, eb}};
        }
    return best;
}

// Gives up the links below the foot of the lowest-ending pair, its feet raised as far as its heads allow: they could
// only make windows longer.
void Packing::leave_below(const Window& pair) {
    Index foot = kNone;
    for (const std::size_t i : {0, 1}) {
        const auto& s = steps.at({pair.column[i], pair.column[1 - i]});
        const auto it = std::upper_bound(s.begin(), s.end(), pair.end[1 - i], [](Index e, Step x) { return e < x.to; });
        foot = std::min(foot, layer(pair.column[i], std::prev(it)->from));
    }
    for (Index c = 0; c < at.size(); ++c) {
        const Index lowest = layer(c, 0), highest = static_cast<Index>(columns.member[c].size() - 1);
        if (foot > lowest) at[c] = std::max(at[c], std::min(highest, foot - lowest));
    }
}

// `w` with the one more column that makes it least larger; empty if none fits.
Window Packing::grown(const Window& w) const {
    Window best;
    double least = 0;
    if (w.column.size() == kMostColumns) return best;
    for (const auto& [c, unused] : rivals[w.column[0]]) {
        if (std::find(w.column.begin(), w.column.end(), c) != w.column.end()) continue;
        Window v = w;
        Index own = 0;
        for (std::size_t i = 0; i < w.column.size() && own != kNone; ++i) {
            const Index d = w.column[i];
            const Index ec = end(c, d), ed = ec == kNone ? kNone : end(d, c);
            if (ed == kNone)
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
    for (Window w = p.lowest_pair(); !w.column.empty() && p.work < kMostWork; w = p.lowest_pair()) {
        p.leave_below(w);
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
