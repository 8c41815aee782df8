#include "sequence/canon.hpp"

#include "base/mix.hpp"
#include "geom/disjoint_sets.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace filum::sequence {

namespace {

constexpr int kSweeps = 8;    // most sweeps up and down, if they still separate nodes
constexpr int kSetApart = 16; // nodes per part that are individualised
constexpr std::uint64_t kLink = 0x9e3779b97f4a7c15U, kPrecedence = 0xc2b2ae3d27d4eb4fU, kChosen = 0x165667b19e3779f9U,
                        kTool = 0xd6e8feb86659fd93U;

// Colours that distinguish nodes by the colours of their neighbours, and by the neighbour in the same column.
struct Colours {
    const Graph& g;
    std::span<const Index> column;
    std::vector<std::uint64_t> of;

    Colours(const Graph& graph, std::span<const Index> columns) : g(graph), column(columns), of(graph.size()) {
        for (Index v = 0; v < g.size(); ++v) of[v] = mixed(g.node[v].layer + kLink + kTool * g.node[v].tool);
    }
    [[nodiscard]] std::uint64_t sum(Index v, std::span<const Index> others, std::uint64_t kind) const {
        std::uint64_t sum = 0;
        for (const Index u : others) sum += mixed(of[u] + (column[u] == column[v] ? 3 : 1) * kind);
        return sum;
    }
    void tell(Index v, const Arcs& links, const Arcs& precedence) {
        of[v] = mixed(of[v] * 5 + sum(v, links[v], kLink) + 3 * sum(v, precedence[v], kPrecedence));
    }
    // Arcs lead to higher layers, and nodes are numbered by layer, so a sweep carries a colour through all layers.
    void sweep() {
        for (Index v = 0; v < g.size(); ++v) tell(v, g.down, g.before);
        for (Index v = g.size(); v-- > 0;) tell(v, g.up, g.after);
    }
    [[nodiscard]] std::size_t many() const {
        auto all = of;
        std::sort(all.begin(), all.end());
        return static_cast<std::size_t>(std::unique(all.begin(), all.end()) - all.begin());
    }
    std::size_t refine() {
        std::size_t before = 0;
        for (int i = 0; i < kSweeps; ++i) {
            sweep();
            const std::size_t now = many();
            if (now == before) break;
            before = now;
        }
        return before;
    }
};

// The nodes of the connected parts, ascending; parts by their lowest node.
std::vector<std::vector<Index>> connected_parts(const Graph& g) {
    geom::DisjointSets sets(g.size());
    for (Index u = 0; u < g.size(); ++u) {
        for (const Index v : g.up[u]) sets.unite(u, v);
        for (const Index v : g.after[u]) sets.unite(u, v);
    }
    std::vector<Index> part;
    std::vector<std::vector<Index>> out(sets.number(part));
    for (Index v = 0; v < g.size(); ++v) out[part[v]].push_back(v);
    return out;
}

// Individualises one of the lowest nodes with equal colours in each part; false if there are none.
bool set_apart(const std::vector<std::vector<Index>>& parts, Colours& c) {
    auto& colour = c.of;
    bool any = false;
    for (auto nodes : parts) {
        std::sort(nodes.begin(), nodes.end(), [&](Index a, Index b) {
            return std::tuple(c.g.node[a].layer, colour[a], a) < std::tuple(c.g.node[b].layer, colour[b], b);
        });
        const auto alike =
            std::adjacent_find(nodes.begin(), nodes.end(), [&](Index a, Index b) { return colour[a] == colour[b]; });
        if (alike == nodes.end()) continue;
        colour[*alike] = mixed(colour[*alike] + kChosen);
        any = true;
    }
    return any;
}

} // namespace

std::vector<std::uint64_t> colours(const Graph& g) {
    const std::vector<Index> no_columns(g.size(), 0);
    Colours c(g, no_columns);
    c.refine();
    return std::move(c.of);
}

std::vector<Index> canonical_order(const Graph& g, std::span<const Index> column) {
    Colours c(g, column);
    auto& colour = c.of;
    const auto parts = connected_parts(g);
    for (int i = 0; c.refine() < g.size(); ++i)
        if (i == kSetApart || !set_apart(parts, c)) break;
    std::vector<std::uint64_t> of_part(g.size());
    std::vector<Index> part(g.size());
    for (const auto& nodes : parts) {
        std::uint64_t sum = 0;
        for (const Index v : nodes) sum += mixed(colour[v]);
        for (const Index v : nodes) {
            of_part[v] = sum;
            part[v] = nodes[0];
        }
    }
    std::vector<Index> out(g.size());
    std::iota(out.begin(), out.end(), 0U);
    const auto key = [&](Index v) { return std::tuple(g.node[v].layer, of_part[v], part[v], colour[v], column[v], v); };
    std::sort(out.begin(), out.end(), [&](Index a, Index b) { return key(a) < key(b); });
    return out;
}

std::vector<Part> parts(const Graph& g, const Columns& columns) {
    const auto connected = connected_parts(g);
    std::vector<Part> out(connected.size());
    std::vector<Index> part(g.size()), number(g.size()), column(columns.member.size(), kNone);
    for (Index p = 0; p < connected.size(); ++p)
        for (const Index v : connected[p]) part[v] = p;
    for (const Index v : canonical_order(g, columns.of)) {
        Part& p = out[part[v]];
        number[v] = static_cast<Index>(p.node.size());
        p.node.push_back(v);
    }
    for (Part& p : out) {
        const auto copy = [&](const Arcs& from) {
            Arcs to;
            for (const Index v : p.node) {
                for (const Index w : from[v]) to.to.push_back(number[w]);
                std::sort(to.to.begin() + to.start.back(), to.to.end());
                to.start.push_back(static_cast<Index>(to.to.size()));
            }
            return to;
        };
        p.g.up = copy(g.up);
        p.g.down = copy(g.down);
        p.g.after = copy(g.after);
        p.g.before = copy(g.before);
        for (const Index v : p.node) {
            p.g.node.push_back(g.node[v]);
            Index& c = column[columns.of[v]];
            if (c == kNone) {
                c = static_cast<Index>(p.columns.member.size());
                p.columns.member.emplace_back();
            }
            p.columns.member[c].push_back(number[v]);
            p.columns.of.push_back(c);
        }
    }
    return out;
}

} // namespace filum::sequence
