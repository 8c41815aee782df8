// Insets, and a note of the parts of a region that no bead reaches.
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"

namespace filum::polygon {

// The points of `area` at least `by` mm from its outline (grown if negative), simplified. Error below 10 um.
Loops inset(const Loops& area, double by);

// Adds one note for the connected parts of `region` outside `reached`: their number, their area in mm2 and the place of
// the largest. A part counts if it is larger than one bead width squared and holds a disc half a bead wide. Smaller
// parts are tips of corners, which no round bead fills. Returns the area of the parts that count, mm2.
double note_unplaced(const Loops& region, const Loops& reached, double bead_width, Notes& notes);

} // namespace filum::polygon
