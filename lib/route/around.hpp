// Past what stands in the way, at one height.
#pragma once

#include "route/fan.hpp"

namespace filum::route {

// A short way from (0, 0, rise) to (1, 0, rise) at that rise all along: the shortest over a grid of the places that are
// free (A*, 8 neighbours; P. Hart, N. Nilsson, B. Raphael, 1968), then straightened.  The grid fills the ellipse of the
// ways no longer than `most` mm with at most about 3000 places, none nearer to each other than 0.5 mm.
// Nothing if there is none.  Ties: the place nearer to the start, then farther to the right.
Way around(const Fan& fan, double rise, double most);

} // namespace filum::route
