// The squares between the rows of a layer and the crossing rows of the layer below.
#pragma once

#include "infill/infill.hpp"

namespace filum::infill {

// Returns the part of `within` (simple) that lies in squares reached by `area`. Each square lies between two rows with
// the spacing of `lines` and two rows of the layer below, which has the same spacing across. So additional rows between
// those of a square end on rows below.
//
// An area that reaches less than half a bead beyond a row does not reach the square there. A part of `area` lower than
// half a bead within its row reaches no square.
Loops whole_squares(const Loops& area, const Loops& within, const Lines& lines);

} // namespace filum::infill
