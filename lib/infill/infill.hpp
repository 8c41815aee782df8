// Sparse infill as closed curves (docs/algorithms/infill.md).
//
// The plane is parted into cells of two colours by a function u: cell k is where u / spacing has the whole part k.  The
// outlines of the even cells within an area are closed, cross nothing, pass each line u = k spacing exactly once, and
// follow the area's outline between lines, which anchors them there.
#pragma once

#include "polygon/region.hpp"

namespace filum::infill {

using polygon::Loops;

struct Lines {
    polygon::Pattern pattern = polygon::Pattern::rows;
    double direction = 0;    // rad, of rows, from the x axis
    double spacing = 2;      // mm, from line to line
    double bead_width = 0.4; // mm
};

// The closed curves that fill `area` (simple): half a bead inside its outline, none nearer than a bead to itself or
// another.  Even cells narrower than a bead get none.
Loops loops(const Loops& area, const Lines& lines);

// mm of all loops.
double length(const Loops& loops);

} // namespace filum::infill
