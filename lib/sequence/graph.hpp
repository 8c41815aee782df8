// The graph of a job: which region must be printed before which, and where a stroke can climb.
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

// Arcs of a directed graph: to[start[i] .. start[i + 1]) are the heads of node i's arcs, ascending.
struct Arcs {
    std::vector<Index> start{0}, to;
    [[nodiscard]] std::span<const Index> operator[](Index i) const {
        return {to.data() + start[i], start[i + 1] - start[i]};
    }
    [[nodiscard]] std::size_t size() const { return to.size(); }
};

using Pair = std::pair<Index, Index>;

// The arcs of `n` nodes in order, each once.
Arcs arcs(std::size_t n, std::vector<Pair> pairs);
Arcs reversed(const Arcs& a);

struct Node {
    Index layer = 0;   // counts the layers that hold regions, from 0
    double z = 0;      // mm, top of the region
    geom::Vec2 centre; // of its area
};

// Every arc leads to a higher layer, so layer order is always feasible.
struct Graph {
    std::vector<Node> node;
    Arcs up, down;      // links: a stroke may go from a region straight to one above it; and reversed
    Arcs after, before; // precedence: support and head; and reversed
    [[nodiscard]] Index size() const { return static_cast<Index>(node.size()); }
};

// A column: regions of consecutive layers, each supported by the one before.  Columns partition the regions.
struct Columns {
    std::vector<std::vector<Index>> member; // lowest first; columns by (lowest layer, first member)
    std::vector<Index> of;                  // the column of each region
};

// What support alone says about `regions`, which come layer by layer, ids without gaps: links where the regions say so,
// support where they lie on a region of the layer next below.
// Throws Error(bad_input) if ids or layers do not ascend, an overlap names no region of a layer below, or a link one of
// another than the next below.
Graph support_graph(std::span<const polygon::Region> regions);

// Of those that a gap parts, as of a part from what carries it: below, above.  They have no say in columns.
std::vector<Pair> carried_from_afar(std::span<const polygon::Region> regions);

// Each region continues the column of one that carries it: one that a link leads from, if there is any, then one with
// the longest way down, then that of the least `colour` (by region); if that one, likewise, is continued by it.  Of
// regions of the same colour none is chosen: there is nothing to choose them by but their number.  Nor have areas a
// say, so that rounding has none.  For a graph with no other precedence than support.
Columns columns(const Graph& g, std::span<const std::uint64_t> colour);

// `g` with more precedence.
void add_precedence(Graph& g, std::vector<Pair> more);

} // namespace filum::sequence
