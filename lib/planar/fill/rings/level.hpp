// The isoline of the lane coordinate at which lanes end, around the area for another pattern.
#pragma once

#include "fill/rings/beading.hpp"

namespace filum::fill::rings {

// The area where the lane coordinate is above `lane`: outer loops counter-clockwise, holes clockwise, without
// crossings. Arcs deviate by at most `tolerance` mm.
Loops beyond(const Beading& beading, int lane, double tolerance);

} // namespace filum::fill::rings
