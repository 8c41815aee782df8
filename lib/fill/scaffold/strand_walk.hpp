// The order in which a scaffold's strands are laid, in as few strokes as the boundary allows.
#pragma once

#include "fill/scaffold/strands.hpp"

#include <vector>

namespace filum::fill::scaffold {

// One strand or arc, from its first node to its second, or against that.
struct Step {
    std::uint32_t id = 0;
    bool strand = false, against = false;
};

struct StrandWalk {
    std::vector<std::vector<Step>> trails; // one, unless strands cannot be reached along the boundary
    double along = 0;                      // mm along the boundary
    double again = 0;                      // mm of it, and of strands, that are passed more than once
};

// Lays every strand once, from `graph.start` if there is one.  From the end of a strand the walk goes along the
// boundary to the nearest end of a strand not laid yet: mostly the next turn of a meander.  Where the
// boundary does not lead to what is left, the walk passes a strand again; where nothing leads there, a new trail
// begins. Of several such walks, which begin at other corners and prefer to go up or down, the one with the least
// `along` + `again` is taken.  Tie: the first.
//
// No walk can do without passing again, in general: every loop holds an even number of strand ends, so only turns that
// pair them up alternately pass nothing twice, and these are one trail only where the area is monotone across the
// strands, begun and ended at its outermost two.
StrandWalk strand_walk(const StrandGraph& graph);

} // namespace filum::fill::scaffold
