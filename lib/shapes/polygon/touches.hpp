// Splits loops where they touch themselves.
#pragma once

#include "polygon/loops.hpp"

#include <optional>
#include <vector>

namespace filum::polygon {

// The same area, with loops that do not touch themselves. A loop is split into two where it returns to one of its
// vertices, or where a vertex lies on one of its edges. Coordinates are compared on the grid of clip.hpp. Different
// loops may still touch each other. O(n log n) in the points, where Clipper's StrictlySimple is quadratic.
Loops parted_at_touches(const Loops& a);

// The result of nesting() for loops that may touch each other in points, but do not cross. Nothing if outer loops and
// holes do not alternate.
std::optional<std::vector<int>> nesting_of_touching(const Loops& a);

} // namespace filum::polygon
