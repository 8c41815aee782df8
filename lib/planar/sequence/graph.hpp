// The graph of a job: which regions must be printed before which, and where a stroke can climb.
#pragma once

#include "geom/vec.hpp"
#include "polygon/region.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace filum::sequence {

using Index = std::uint32_t;
inline constexpr Index kNone = ~Index{0};

// Arcs of a directed graph: to[start[i]] to to[start[i + 1] - 1] are the heads of node i's arcs, ascending.
struct Arcs {
    std::vector<Index> start{0}, to;
    [[nodiscard]] std::span<const Index> operator[](Index i) const {
        return {to.data() + start[i], start[i + 1] - start[i]};
    }
    [[nodiscard]] std::size_t size() const { return to.size(); }
};

using Pair = std::pair<Index, Index>;

// The arcs of `n` nodes, sorted, without duplicates.
Arcs arcs(std::size_t n, std::vector<Pair> pairs);
Arcs reversed(const Arcs& a);

struct Node {
    Index layer = 0;      // number of the layer among those with regions, from 0
    double z = 0;         // mm, top of the region
    geom::Vec2 centre;    // of its area
    Index tool = 0;       // number of the tool that prints it
    bool bed = false;     // it begins below the top of the lowest region, so nothing can carry it
    bool carried = false; // a region ends where it begins, and carries it
};

// Every arc leads to a higher layer, so printing layer by layer is always possible.
struct Graph {
    std::vector<Node> node;
    Arcs up, down;      // links: a stroke may go directly from a region to one above it of the same tool; and reversed
    Arcs after, before; // precedence by support and head; and reversed
    [[nodiscard]] Index size() const { return static_cast<Index>(node.size()); }
};

// The numbers of the tools that print the regions, ascending.
std::vector<Index> tools(const Graph& g);

// Columns: regions of one tool, each supported by the one before, which ends where it begins. They partition the
// regions.
struct Columns {
    std::vector<std::vector<Index>> member; // lowest first; columns by (lowest layer, first member)
    std::vector<Index> of;                  // the column of each region
};

// The graph of `regions` by support alone; they must come layer by layer with consecutive ids. Links as given by the
// regions, precedence where they rest on a region of the layer below: the one where they begin (Region::rests_on).
// Throws Error(bad_input) if ids or layers do not ascend, if an overlap names a region that is not on a layer below,
// or if a link leads to a layer other than the one where the region begins, or to a region of another tool.
Graph support_graph(std::span<const polygon::Region> regions);

// Pairs (below, above) of regions with a gap in between, as between a part and its support. They do not affect
// columns.
std::vector<Pair> carried_from_afar(std::span<const polygon::Region> regions);

// Each region continues the column of a region that carries it: of those that link to it if there are any, then of
// those with the longest path down, the one of the least `colour` (per region), if it is that one's choice by the same
// rule. Regions of equal colours are not chosen, as only their numbers differ. Areas do not count, so rounding has no
// effect. For a graph whose only precedence is support.
Columns columns(const Graph& g, std::span<const std::uint64_t> colour);

// Adds precedences to `g`.
void add_precedence(Graph& g, std::vector<Pair> more);

} // namespace filum::sequence
