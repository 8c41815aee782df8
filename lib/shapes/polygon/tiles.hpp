// Divide and conquer for operations on outlines whose cost grows faster than their points.
#pragma once

#include "polygon/loops.hpp"

#include <functional>
#include <span>

namespace filum::polygon {

// Returns the outline of an area. At any place, the outline must not depend on parts of the inputs farther away than a
// known reach.
using Operation = std::function<Loops(std::span<const Loops>)>;

// The result of `operation` for `inputs`, computed tile by tile. The inputs are halved across the longer side until no
// tile has more than about two thousand points. Each tile has a margin of `reach` mm. The results are stitched together
// where their outlines cross the cuts. They equal those of one operation up to rounding (2 um at the cuts) and the
// order of the loops. Where the two sides of a cut disagree, the cut is moved, or the operation is done in one piece.
// It is also done in one piece where inputs cross themselves at a cut. Results are simple, outer loops
// counter-clockwise, holes clockwise. Inputs must be so too, unless the operation unites them.
Loops tiled(std::span<const Loops> inputs, double reach, const Operation& operation);

} // namespace filum::polygon
