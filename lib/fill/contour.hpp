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
    bool fit = true;         // share a wall's odd thickness between its innermost beads, and follow thin walls
};

// Closed rings of one connected region (outer loop, then holes), in the order of depth; every point carries its width,
// or all share one.  Without `fit` ring k lies (k - 1/2) bead widths inside the outline, to 10 um, and is one bead
// wide: the classical fill, with its voids and overlaps of up to a bead at the medial axis.  With `fit` the rings are
// those of `spiral` before they are joined; they are checked for crossings and made again like that.
// Note: area that no bead reaches (mm2).
std::vector<toolpath::Curve> contour(const polygon::Loops& region, const ContourOptions& options, Notes& notes);

} // namespace filum::fill
