// How few strokes are possible: proven lower bounds.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

// Strokes that links alone demand: regions less a maximum matching.
Index path_cover(const Graph& g);

// Strokes that links and precedence demand.  An order of all regions, restricted to a slab of layers, uses no more of
// the links inside it than the best order of that slab alone; so cut the part into slabs that share their border
// layers, and strokes >= regions - sum of the most links that each slab can use.  Slabs of 1, 2, 4 ... layers are
// solved exactly as far as `budget` (precedences looked at) allows, and the best cut is found by a dynamic program over
// the layers.  Adds the steps taken to `steps`.
Index slab_bound(const Graph& g, const Columns& columns, std::span<const double> weight, std::uint64_t budget,
                 std::uint64_t& steps);

} // namespace filum::sequence
