// The squares between the rows of a layer and those of the one below, which lie across them.
#pragma once

#include "infill/infill.hpp"

namespace filum::infill {

// What of `within` (simple) lies in squares that `area` reaches: each lies between two rows with the spacing of
// `lines`, and two of the layer below, which has the same across.  So more rows between those of a square end on rows
// below. What reaches less than half a bead beyond a row ends on it; what is lower than that in a square reaches none.
Loops whole_squares(const Loops& area, const Loops& within, const Lines& lines);

} // namespace filum::infill
