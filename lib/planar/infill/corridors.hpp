// Corridors that join isolated cells to others. Private to lib/planar/infill.
#pragma once

#include "polygon/loops.hpp"

namespace filum::infill {

// Returns `cells` (simple) with corridors. Every connected part that does not reach the outline of `room` gets one to
// the nearest part of another group. Then all cells can be joined along that outline. A corridor is as wide as a bead,
// so its two sides lie one bead apart. Ties: the first part, then the first place.
polygon::Loops with_corridors(const polygon::Loops& cells, const polygon::Loops& room, double bead_width);

} // namespace filum::infill
