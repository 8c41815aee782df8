#include "sequence/bound.hpp"

#include "sequence/matching.hpp"
#include "sequence/search.hpp"

#include <algorithm>
#include <numeric>

namespace filum::sequence {

Index path_cover(const Graph& g) { return g.size() - matched(maximum_matching(g.up)); }

namespace {

constexpr std::size_t kWidth = 64;
constexpr std::uint64_t kSlabBudget = 2'000'000;

// A few regions with what holds between them, numbered anew in the same order.
struct Piece {
    Graph g;
    Columns columns;
    std::vector<double> weight;
};

struct Slabs {
    const Graph& g;
    const Columns& columns;
    std::span<const double> weight;
    std::vector<Index> first; // of each layer, and one past the end
    std::vector<Index> name;  // scratch: new number of a region
    std::uint64_t work = 0;

    Slabs(const Graph& graph, const Columns& c, std::span<const double> w) : g(graph), columns(c), weight(w) {
        for (Index v = 0; v < g.size(); ++v)
            while (first.size() <= g.node[v].layer) first.push_back(v);
        first.push_back(g.size());
        name.assign(g.size(), kNone);
    }
    [[nodiscard]] std::size_t layers() const { return first.size() - 1; }

    // The regions lo .. hi, those that links or precedence among them hold together in one group each.
    [[nodiscard]] std::vector<std::vector<Index>> groups(Index lo, Index hi) const {
        std::vector<Index> up(hi - lo);
        std::iota(up.begin(), up.end(), 0U);
        const auto root = [&](Index i) {
            while (up[i] != i) i = up[i] = up[up[i]];
            return i;
        };
        for (Index v = lo; v < hi; ++v)
            for (const auto* arcs : {&g.before, &g.down})
                for (const Index u : (*arcs)[v])
                    if (u >= lo) {
                        const Index a = root(u - lo), b = root(v - lo);
                        up[std::max(a, b)] = std::min(a, b);
                    }
        std::vector<std::vector<Index>> out;
        std::vector<Index> place(hi - lo, kNone);
        for (Index v = lo; v < hi; ++v) {
            Index& at = place[root(v - lo)];
            if (at == kNone) at = static_cast<Index>(out.size()), out.emplace_back();
            out[at].push_back(v);
        }
        return out;
    }

    Piece piece(const std::vector<Index>& members) {
        Piece p;
        for (Index i = 0; i < members.size(); ++i) {
            name[members[i]] = i;
            p.g.node.push_back(g.node[members[i]]);
            p.weight.push_back(weight[members[i]]);
        }
        std::vector<Pair> links, precedence;
        std::vector<Index> column(columns.member.size(), kNone);
        for (const Index v : members) {
            for (const Index u : g.down[v])
                if (name[u] != kNone) links.emplace_back(name[u], name[v]);
            for (const Index u : g.before[v])
                if (name[u] != kNone) precedence.emplace_back(name[u], name[v]);
            Index& c = column[columns.of[v]];
            if (c == kNone) c = static_cast<Index>(p.columns.member.size()), p.columns.member.emplace_back();
            p.columns.member[c].push_back(name[v]);
            p.columns.of.push_back(c);
        }
        for (const Index v : members) name[v] = kNone;
        p.g.up = arcs(members.size(), std::move(links));
        p.g.down = reversed(p.g.up);
        p.g.after = arcs(members.size(), std::move(precedence));
        p.g.before = reversed(p.g.after);
        return p;
    }

    // The most links that the layers a .. b can use, proven; the links of their best matching where the search gives
    // up.
    Index most_links(Index a, Index b) {
        Index links = 0;
        for (const auto& members : groups(first[a], first[b + 1])) {
            if (members.size() == 1) continue;
            const Piece p = piece(members);
            work += p.g.after.size() + members.size();
            const Index cover = matched(maximum_matching(p.g.up));
            const Found f = search(p.g, p.columns, p.weight, kWidth, kSlabBudget);
            work += f.work;
            links += f.optimal ? static_cast<Index>(members.size()) - cost(p.g, f.order).strokes : cover;
        }
        return links;
    }
};

} // namespace

Index slab_bound(const Graph& g, const Columns& columns, std::span<const double> weight, std::uint64_t budget,
                 std::uint64_t& steps) {
    if (g.size() == 0) return 0;
    Slabs s(g, columns, weight);
    const auto n = static_cast<Index>(s.layers());
    struct Slab {
        Index from, links;
    };
    std::vector<std::vector<Slab>> ending(n); // by their last layer
    for (Index height = 1; height < 2 * n && s.work < budget; height *= 2) {
        const Index step = std::max<Index>(1, height / 8);
        for (Index a = 0; a + 1 < n && s.work < budget; a += step) {
            const Index b = std::min(n - 1, a + height);
            ending[b].push_back({a, s.most_links(a, b)});
        }
    }
    // the least sum of links over all cuts of the layers below; a missing slab of one layer counts its matching
    std::vector<Index> least(n, 0);
    for (Index b = 1; b < n; ++b) {
        Index most = kNone;
        for (const Slab& x : ending[b]) most = std::min(most, least[x.from] + x.links);
        if (most == kNone) most = least[b - 1] + (s.first[b + 1] - s.first[b]);
        least[b] = most;
    }
    steps += s.work;
    return g.size() - least[n - 1];
}

} // namespace filum::sequence
