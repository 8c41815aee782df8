// Zigzag fill in one closed curve (docs/algorithms/fill.md).
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill {

struct ZigzagOptions {
    double bead_width = 0.4; // mm
    double angle = 0;        // rad, of the rows from the x axis
};

// Fills one connected region (outer loop first, then holes) with parallel rows.  Thin walls cut the region into a tree
// of corridors two beads wide (see maze.hpp); the ring along their outline is the zigzag: up one side of each corridor,
// back down the other, from row to row along the region's outline.  So it is closed and can be begun anywhere.  What
// rings it takes besides (around a wall with two free ends, in a wide place) are joined to it by exchanges.  Where the
// region is thinner than two beads the two lanes share what there is.  Rows are from 0.8 to 1.2 bead widths wide,
// fitted to the flat parts of the outline; every point carries its width.
//
// The result is checked: should it cross itself or be more than one curve, it is made again with finer lines, then with
// other rows; the best is returned.  Order: the longest curve first.  Note: curves that could not be joined (count).
// `unplaced`, where given, is set to the area that no bead reaches, mm2: corners and tips.
std::vector<toolpath::Curve> zigzag(const polygon::Loops& region, const ZigzagOptions& options, Notes& notes,
                                    double* unplaced = nullptr);

} // namespace filum::fill
