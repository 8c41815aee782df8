// A fast test of whether loops are simple, so that they need no union.
#pragma once

#include "polygon/loops.hpp"

#include <optional>
#include <vector>

namespace filum::polygon {

inline constexpr double kGridPerMm = 1e4;           // grid units per mm: clip.hpp rounds to 0.1 um
inline constexpr double kGridStep = 1 / kGridPerMm; // mm

// Whether `loops` are exactly the outline of the area they wind round, on the grid of 0.1 um to which clip.hpp rounds.
// No two edges cross, touch or overlap; outer loops run counter-clockwise, holes clockwise, nested in turn. A union
// would return them unchanged. If false, a union may be needed. The sweep stops at the first doubt (Shamos and Hoey
// 1976) and uses exact integers. It takes about 50 ns per point, against more than 1 us for the union. Precondition:
// coordinates within 1e8 mm.
bool is_simple(const Loops& loops);

// For each loop the smallest loop around it: for a hole its outer loop, for an outer loop the hole it lies in, -1 if
// none. Nothing if the loops are not simple.
std::optional<std::vector<int>> nesting(const Loops& loops);

} // namespace filum::polygon
