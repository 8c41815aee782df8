// Separate parallel lines, as ordinary slicers print them: the baseline (Nf, "normal fill", of the 2019 paper).
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill::rows {

struct RectilinearOptions {
    double bead_width = 0.4; // mm
    double angle = 0;        // rad, of the lines from the x axis
    int rings = 0;           // closed rings along the outline, which come first
};

// Fills one connected region with open lines, after `rings` closed rings. In each connected part inside the rings, the
// lines are as wide as they are apart. The width is within 15 % of bead_width, fitted to the height of the part and to
// its flat edges along the lines. Lines end half a width inside.
//
// Order: from a line to an overlapping one in the next row, alternately forwards and backwards. Where there is none,
// the lowest remaining line follows. Tie: the leftmost. Without rings, a note gives the area of parts narrower than a
// bead, which get no line.
std::vector<toolpath::Curve> rectilinear(const polygon::Loops& region, const RectilinearOptions& options, Notes& notes);

} // namespace filum::fill::rows
