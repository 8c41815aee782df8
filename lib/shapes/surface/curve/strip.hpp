// The shortest line within a strip of triangles.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surface::curve {

// A line from `a` to `b` with places where it crosses edges: the shortest one in the strip of triangles that connects
// them across the fewest edges, none farther than `reach` mm from `a`. Empty if there is no strip. Unlike join() it
// does not need a plane, so it follows creases and folds.
Line through_strip(const Surface& s, const Place& a, const Place& b, double reach);

} // namespace filum::surface::curve
