// The convex hull of points in the plane.
#pragma once

#include "geom/vec.hpp"

#include <span>
#include <vector>

namespace filum::geom {

// The corners of the hull, counter-clockwise from the leftmost (of several the lowest), none of them on the line
// between its neighbours but for rounding; fewer than three if all points lie on a line.  A. Andrew 1979; n log n.
std::vector<Vec2> convex_hull(std::span<const Vec2> points);

} // namespace filum::geom
