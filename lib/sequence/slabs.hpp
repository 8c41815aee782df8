// Parts of a graph between two layers, small enough for tables of regions by columns.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

// The regions first .. first + g.size() - 1 of the whole, numbered anew from 0, with what holds between them.
struct Slab {
    Index first = 0;
    Graph g;
    Columns columns;
};

// Slabs from below, each of as many layers as keep regions times columns at most `most`, but two at least.  A slab
// begins with the last layer of the one before, so that each link is in one of them.
std::vector<Slab> slabs(const Graph& g, const Columns& columns, std::size_t most);

} // namespace filum::sequence
