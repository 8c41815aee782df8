// Even spacing: rings moved and widened so that the beads of a wall share its thickness (docs/algorithms/fill.md).
#pragma once

#include "fill/rings.hpp"

#include <vector>

namespace filum::fill {

// Rings whose points carry a bead width.
struct BeadRings {
    Loops loops;
    std::vector<double> width; // mm, per point
};

// Rings at depths w/2, 3w/2, ... leave between the two innermost of a wall whatever is left of its thickness, from
// nothing to two widths.  Here the last `lanes` rings on each side of the medial axis share that error: with half gap g
// in the middle each moves by its part of e = g - w/2 and becomes e/lanes wider (the even-bead rule: a wall of
// half-thickness r gets round(r/w) beads a side, each r/round(r/w) wide if lanes allow).  Along the rings the moves are
// smoothed over about one width, so that the number of beads can change without a jump.
// Where moved rings would cross, the moves are taken back, in the worst case all of them.
// lanes = 0 moves nothing and gives every point `width`.
// `boundary`: the region's outline.  Points are added where the width changes, and dropped where nothing does.
BeadRings even_spacing(const Rings& rings, const Loops& boundary, double width, int lanes, double tolerance);

} // namespace filum::fill
