// Takes from cells what is narrower than a bead. Private to lib/planar/infill.
#pragma once

#include "polygon/loops.hpp"

namespace filum::infill {

// The same as polygon::opened(cells, radius, polygon::kBeadArc), up to a quarter of a radius in corners, for cells that
// are at least two radii apart. In most cells, a disc of the radius can roll along the whole outline, which takes no
// Boolean operation: the line that it touches is the outline of the opening. In a corner between two edges that line is
// not an arc but the fewest tangents of it, one or two points in most corners. All other cells, and those with holes,
// go through one Boolean operation together.
polygon::Loops opened_cells(const polygon::Loops& cells, double radius);

} // namespace filum::infill
