// The order of the strands of a scaffold, in as few strokes as the boundary allows.
#pragma once

#include "fill/scaffold/strands.hpp"

#include <vector>

namespace filum::fill::scaffold {

// One strand or arc, from its first node to its second, or backwards if `against`.
struct Step {
    std::uint32_t id = 0;
    bool strand = false, against = false;
};

struct StrandWalk {
    std::vector<std::vector<Step>> trails; // one, unless some strand cannot be reached along the boundary
    double along = 0;                      // mm of boundary
    double again = 0;                      // mm of boundary and strands passed again
};

// Visits every strand, from `graph.start` if there is one. From the end of a strand the walk follows the boundary to
// the nearest end of an unvisited strand. Mostly that is the next turn of a meander. If the boundary leads to none, the
// walk passes a strand again. If nothing leads to one, a new trail begins.
//
// Several walks are tried: they begin at different corners and prefer to go up or down. The one with the fewest trails
// is returned, and among these the one with the least `along` + `again`. Tie: the first.
//
// In general no walk can avoid passing some stretch again. Every loop has an even number of strand ends, so only turns
// that pair them alternately pass nothing again. These form one trail only if the area is monotone across the strands,
// from one outermost strand to the other.
StrandWalk strand_walk(const StrandGraph& graph);

} // namespace filum::fill::scaffold
