// Separate parallel lines: what an ordinary slicer lays, the baseline (the 2019 paper's Nf, "normal fill").
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill::rows {

struct RectilinearOptions {
    double bead_width = 0.4; // mm
    double angle = 0;        // rad, of the lines from the x axis
    int rings = 0;           // closed rings along the outline, laid first
};

// Open lines that fill one connected region, after `rings` closed rings.  In each connected part of the area inside the
// rings the lines are as wide as they are apart: within 15 % of bead_width, fitted to the part's extent and to its flat
// edges along the lines.  They end half a width inside.  Order: from line to overlapping neighbour, back and forth;
// where that ends, from the lowest line left. Tie: the leftmost.  Parts narrower than a bead carry no line; they become
// a note.
std::vector<toolpath::Curve> rectilinear(const polygon::Loops& region, const RectilinearOptions& options, Notes& notes);

} // namespace filum::fill::rows
