// Contour-parallel fill: closed rings, one inside the other, not linked (the 2019 paper's Cp, "contour-parallel").
#pragma once

#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill {

struct ContourOptions {
    double bead_width = 0.4; // mm
    int rings = 0;           // at most this many, from the outline inwards; 0: until the region is full
};

// Closed rings of one connected region (outer loop, then holes), in the order of depth, each point with its width:
// those of `spiral` before they are joined.  They are checked for crossings, and laid finer if there are any.
std::vector<toolpath::Curve> contour(const polygon::Loops& region, const ContourOptions& options);

} // namespace filum::fill
