// Divide and conquer for operations on outlines whose cost grows faster than their points.
#pragma once

#include "polygon/loops.hpp"

#include <functional>
#include <span>

namespace filum::polygon {

// Gives the outline of an area; at any place it must depend on no part of the inputs farther than a known reach away.
using Operation = std::function<Loops(std::span<const Loops>)>;

// What `operation` gives for `inputs`, found tile by tile: halved across the longer side until no tile has more than
// some thousand points, each tile with a margin of `reach` mm, the results stitched together where their outlines
// cross the cuts.  The same up to rounding (2 um at the cuts at most) and the order of the loops.  Where the two sides
// of a cut disagree, the cut is moved, or the operation done in one piece, as it is where inputs cross themselves at a
// cut. Results are simple, outer loops counter-clockwise, holes clockwise, and so are inputs unless the operation
// unites them.
Loops tiled(std::span<const Loops> inputs, double reach, const Operation& operation);

} // namespace filum::polygon
