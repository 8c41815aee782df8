// The convex hull of points in the plane.
#pragma once

#include "geom/vec.hpp"

#include <span>
#include <vector>

namespace filum::geom {

// The corners of the convex hull, counter-clockwise from the leftmost (of several the lowest). No corner is on the
// line between its neighbours, up to rounding; fewer than three if all points are collinear. Monotone chain (A. Andrew
// 1979), n log n.
std::vector<Vec2> convex_hull(std::span<const Vec2> points);

} // namespace filum::geom
