// Closed curves that stand alone, linked to others.  Private to lib/infill.
#pragma once

#include "polygon/loops.hpp"

namespace filum::infill {

// `cells` (simple, within `room`) changed so that along their outlines one comes from any of them, and any outline of a
// connected part of `room`, to any other of that part: by links, two lines a bead apart, across what parts an outline
// from the nearest one.  Across a gap that is a strip added, across a cell a slit.  No link lies nearer than a bead to
// another; where there is no room for that, an outline stays alone.
// Ties: of links about as short as the shortest, the highest strip and the lowest slit, so that links lie on those of
// the layer below though its outlines differ a little, and strips far from slits.
polygon::Loops with_links(const polygon::Loops& cells, const polygon::Loops& room, double bead_width);

} // namespace filum::infill
