// An order of the regions that their relations give them, not their numbers or places.
#pragma once

#include "sequence/graph.hpp"

#include <cstdint>

namespace filum::sequence {

// All nodes, by layer, so that graphs that are alike (isomorphic) come out alike, whichever way their nodes are
// numbered: what is decided by the lower number is then decided by the job itself, and the same part mirrored or cut
// into other triangles is printed in the same strokes.
// Every node is told by what is above and below it, by sweeps up and down the layers until no more nodes are told apart
// (colour refinement, Weisfeiler and Leman 1968).  Where alike ones remain, one of them is set apart and the sweeps are
// repeated, a few times; what is alike after that goes by column, then by number.
std::vector<Index> canonical_order(const Graph& g, std::span<const Index> column);

// The colours of the nodes by those sweeps alone: nodes that are not alike differ, whichever way they are numbered.
std::vector<std::uint64_t> colours(const Graph& g);

// A connected part of a graph, by links and precedence: nothing outside it matters to its order.
struct Part {
    std::vector<Index> node; // of the whole, in canonical order; they are numbered anew from 0
    Graph g;
    Columns columns;
};
std::vector<Part> parts(const Graph& g, const Columns& columns);

} // namespace filum::sequence
