// The shortest way through triangles that hang together.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surface::curve {

// A line from `a` to `b` on the surface, with places where it crosses edges: shortest within a strip of triangles that
// lead from one to the other by the fewest edges, none farther than `reach` mm from `a`.  Empty if there is none.
// Unlike join() it needs no plane to look along, so it follows creases and folds.
Line through_strip(const Surface& s, const Place& a, const Place& b, double reach);

} // namespace filum::surface::curve
