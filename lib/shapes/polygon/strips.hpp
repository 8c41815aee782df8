// Cuts an area into horizontal strips that begin and end where the area does.
#pragma once

#include "polygon/loops.hpp"

#include <vector>

namespace filum::polygon {

// The cuts of an area into horizontal strips about `height` mm high: ascending y, the first and the last at its bounds.
// Strips are 1 - give to 1 + give times `height` high. If the extent does not allow that, all are equally high. Within
// these limits the cuts follow the flat parts of the outline, so that strips begin and end where the area does. The
// cuts minimize the sum over flat stretches of length * distance to the nearest cut, plus a small cost for uneven
// strips. Resolution: height / 40. Tie: the last strip is the lowest possible, then the one before it, and so on.
std::vector<double> strip_bounds(const Loops& area, double height, double give);

} // namespace filum::polygon
