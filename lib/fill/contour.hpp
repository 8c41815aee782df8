// Contour-parallel fill: closed rings, one inside the other, not linked (the 2019 paper's Cp, "contour-parallel").
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill {

struct ContourOptions {
    double bead_width = 0.4; // mm
    int rings = 0;           // at most this many, from the outline inwards; 0: until the region is full
    bool fit = true;         // adapt the spacing to the region's inradius, so that the innermost ring leaves no void
};

// Closed rings of one connected region (outer loop, then holes): ring k lies (k - 1/2) spacings inside the outline.
// With `fit` the spacing and the bead width are inradius / n, n the least number that makes them at most 1.1 times
// bead_width (1 + 0.1 / n, to be exact).
// Order: from outside inwards, in each depth as the offset yields them.  Parts narrower than a bead carry no ring; they
// become a note.  Error of the depth: below 10 um.
std::vector<toolpath::Curve> contour(const polygon::Loops& region, const ContourOptions& options, Notes& notes);

} // namespace filum::fill
