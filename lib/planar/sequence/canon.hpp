// A canonical order of the regions that depends on their relations only.
#pragma once

#include "sequence/graph.hpp"

#include <cstdint>

namespace filum::sequence {

// All nodes by layer, such that isomorphic graphs give the same order however their nodes are numbered. Ties broken by
// the lower number then depend on the job only, and the same part mirrored or with other triangles is printed in the
// same strokes.
// Nodes are distinguished by what is above and below them, in sweeps up and down the layers until nothing changes
// (colour refinement, Weisfeiler and Leman 1968). If equal nodes remain, one of them is individualised and the sweeps
// are repeated, a few times; nodes that are still equal are ordered by column, then by number.
std::vector<Index> canonical_order(const Graph& g, std::span<const Index> column);

// The colours of the nodes by those sweeps alone: nodes of different colours are not equivalent.
std::vector<std::uint64_t> colours(const Graph& g);

// A connected part of a graph, by links and precedence; its order does not depend on the rest.
struct Part {
    std::vector<Index> node; // of the whole, in canonical order; numbered anew from 0
    Graph g;
    Columns columns;
};
std::vector<Part> parts(const Graph& g, const Columns& columns);

} // namespace filum::sequence
