// Regions smaller than the dot that a bead leaves: one loop in the smallest rectangle about them.
#pragma once

#include "fill/cycle.hpp"

namespace filum::fill {

// Whether nested rings can say nothing of the region's shape: no holes, and less than half a bead width squared.
bool is_speck(const Loops& region, double width);

// There and back along the longer side of the rectangle of least area about the region, two lanes of half its breadth
// each (no coordinate finer than the micrometre, which machines are told, and no lane narrower than two).  It covers
// the speck, and no more than twice its hull.  Ties: the rectangle on the earliest edge.
ClosedLine speck_loop(const Loops& region);

} // namespace filum::fill
