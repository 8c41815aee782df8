// Tests whether outlines are simple, and finds which lies inside which, in one sweep over the plane.
#pragma once

#include "polygon/loops.hpp"

#include <optional>
#include <vector>

namespace filum::regions {

// For each loop the one that directly surrounds it, -1 if none. Nothing unless the loops are strictly simple: two edges
// share at most the vertex between neighbours, and no edge has length zero. Coordinates are rounded to the grid of 0.1
// um and compared exactly. O(n log n) (Shamos and Hoey 1976).
std::optional<std::vector<int>> nesting(const polygon::Loops& loops);

} // namespace filum::regions
