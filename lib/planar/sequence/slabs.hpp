// Slabs: parts of a graph between two layers, small enough for tables of regions by columns.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

// The regions first to first + g.size() - 1 of the whole, numbered from 0, with their relations.
struct Slab {
    Index first = 0;
    Graph g;
    Columns columns;
};

// Slabs from below, each of as many layers as keep regions times columns at most `most`, but at least two. A slab
// begins with the last layer of the one before, so that each link is in exactly one.
std::vector<Slab> slabs(const Graph& g, const Columns& columns, std::size_t most);

} // namespace filum::sequence
