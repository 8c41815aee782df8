// Level strips that an area is cut into, so that they begin and end where it does.
#pragma once

#include "polygon/loops.hpp"

#include <vector>

namespace filum::polygon {

// Where to cut an area into level strips about `height` mm high: ascending y, the first and the last at its bounds.
// Strips are from 1 - give to 1 + give times `height` high where the extent allows it at all (all equally high where
// not).  Within that the cuts fall on the flat parts of the outline, so that strips begin and end where the area does:
// the sum over the outline's flat stretches of length * distance to the nearest cut is least, with a small cost for
// uneven strips.  Resolution: height / 40.  Tie: the strips nearest to `height`, from below.
std::vector<double> strip_bounds(const Loops& area, double height, double give);

} // namespace filum::polygon
