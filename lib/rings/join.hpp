// Rings to one closed curve.
#pragma once

#include "rings/lines.hpp"

namespace filum::rings {

// Joins rings, so that they become one closed curve if the region is connected; else one per group, the longest first.
// Wherever rings lie side by side on a ray, they can become a double spiral there: ... 
// `least_void` mm2: what of a wedge may stay open.
std::vector<BeadLine> joined(const Beading& beading, const Rings& rings, double least_void);

} // namespace filum::rings
