// Loops that touch themselves, parted where they do.
#pragma once

#include "polygon/loops.hpp"

#include <optional>
#include <vector>

namespace filum::polygon {

// The same area by loops none of which touches itself: a loop that comes to one of its own vertices again, or to one of
// its own edges by a vertex, becomes two loops there.  Compares coordinates on the grid of clip.hpp.  Different loops
// may still touch each other.  n log n in the points, where Clipper's StrictlySimple is quadratic.
Loops parted_at_touches(const Loops& a);

// As nesting(), of loops that may touch each other in points, but do not cross.  Empty optional if outer loops and
// holes do not take turns.
std::optional<std::vector<int>> nesting_of_touching(const Loops& a);

} // namespace filum::polygon
