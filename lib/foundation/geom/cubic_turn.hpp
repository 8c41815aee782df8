// Turns between two tangents in the plane.
#pragma once

#include "geom/vec.hpp"

#include <vector>

namespace filum::geom {

// A cubic from p with tangent t to q with tangent u, both unit. If p and q lie on a circle with these tangents, it
// deviates from the arc by a thousandth of its radius at most up to a quarter turn, and by two hundredths at a half
// turn. Points are about `step` apart, in the unit of p and q; there are at least five.
std::vector<Vec2> cubic_turn(Vec2 p, Vec2 t, Vec2 q, Vec2 u, double step);

} // namespace filum::geom
