// Insets, and what of a region no bead reaches.
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"

namespace filum::polygon {

// The area at least `by` mm inside (grown if negative), its points thinned out.  Error below 10 um.
Loops inset(const Loops& area, double by);

// Adds one note for the connected parts of `region` outside `reached` that hold more than one bead width squared and a
// disc half a bead wide (the rest are the tips of corners, which no round bead fills): their number, their area in mm2
// and the place of the largest.  Returns that area.
double note_unplaced(const Loops& region, const Loops& reached, double bead_width, Notes& notes);

} // namespace filum::polygon
