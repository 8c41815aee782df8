// A region walled into one long corridor two beads wide: the frame of `zigzag`.
#pragma once

#include "polygon/loops.hpp"

namespace filum::fill::rows {

// `region` (one outer loop and its holes) less thin slits along level lines about `row_height` (two bead widths) apart,
// so placed that what is left is a tree of corridors: rows, joined by doors two beads wide at their ends.  A ring along
// the outline of that is one closed zigzag.
//  - The lines fall on flat parts of the outline where they can (polygon/strips.hpp).
//  - There is no wall where the area beside it would be thinner than a bead over more than a row's height: that sliver
//    joins the row below or above it.
//  - Doors open at the left end where the corridor is wide enough there, else at the right; between two rows that share
//    several lines, at the first.  Where no end is wide enough the whole line stays open.
polygon::Loops maze(const polygon::Loops& region, double bead_width, double row_height);

} // namespace filum::fill::rows
