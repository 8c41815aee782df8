// Links between closed curves that stand alone. Private to lib/planar/infill.
#pragma once

#include "polygon/loops.hpp"

namespace filum::infill {

// Returns `cells` (simple, within `room`) with links. They connect all outlines of a connected part of `room`: those of
// its cells and its own. A link consists of two lines one bead apart, across the gap or cell between an outline and the
// nearest one. Across a gap the link is an added strip, across a cell a slit.
//
// Between two links there is room for a bead. Where there is none, an outline stays alone.
//
// Ties: among links about as short as the shortest, the highest strip or the lowest slit. So links lie above those of
// the layer below even if its outlines differ a little, and strips lie far from slits.
polygon::Loops with_links(const polygon::Loops& cells, const polygon::Loops& room, double bead_width);

} // namespace filum::infill
