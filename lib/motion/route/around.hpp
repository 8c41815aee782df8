// Searches a way around obstacles at one height.
#pragma once

#include "route/fan.hpp"

namespace filum::route {

// A short way from (0, 0, rise) to (1, 0, rise) at constant rise: the shortest over a grid of free places (A*, 8
// neighbours; P. Hart, N. Nilsson, B. Raphael, 1968), straightened. The grid covers the ellipse of ways no longer than
// `most` mm with at most about 3000 places, at least 0.5 mm apart.
// Empty if there is none. Ties: the place nearer to the start, then the one farther to the right.
Way around(const Fan& fan, double rise, double most);

} // namespace filum::route
