// Cells that stand alone, joined to others.  Private to lib/infill.
#pragma once

#include "polygon/loops.hpp"

namespace filum::infill {

// `cells` (simple) with a corridor as wide as a bead, so that its two sides are laid a bead apart, from every connected
// part that does not reach the outline of `room` to the part nearest to it.  Then all of them can be joined along that
// outline.  Ties: the part, then the place, that comes first.
polygon::Loops with_corridors(const polygon::Loops& cells, const polygon::Loops& room, double bead_width);

} // namespace filum::infill
