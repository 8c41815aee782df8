// Divides a region into one long corridor, two beads wide: the frame of `zigzag`.
#pragma once

#include "polygon/loops.hpp"

namespace filum::fill::rows {

// Cuts thin slits into `region` (one outer loop and its holes), along level lines about `row_height` apart (two bead
// widths). The result is a tree of corridors: rows, connected at their ends by doors two beads wide. So one ring along
// its outline is one closed zigzag.
//  - Lines coincide with flat parts of the outline where possible (polygon/strips.hpp).
//  - A slit has no stretch where the area beside it would be thinner than a bead over more than a row's height. That
//    sliver joins the row below or above it.
//  - A door is at the left end if the corridor is wide enough there, else at the right. Two rows that share several
//    borders have one at the first. If neither end is wide enough, the whole border stays open.
polygon::Loops maze(const polygon::Loops& region, double bead_width, double row_height);

} // namespace filum::fill::rows
