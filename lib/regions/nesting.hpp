// Are these outlines simple, and which lies inside which: one sweep over the plane.
#pragma once

#include "polygon/loops.hpp"

#include <optional>
#include <vector>

namespace filum::regions {

// For each loop the one that directly surrounds it, -1 if none.  nullopt unless the loops are strictly simple: no two
// edges share a point but neighbours their common vertex, no edge has length zero.
// Coordinates are taken on the grid of 0.1 um and compared exactly.  O(n log n) (Shamos and Hoey 1976).
std::optional<std::vector<int>> nesting(const polygon::Loops& loops);

} // namespace filum::regions
