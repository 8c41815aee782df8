// The line that lanes end at: what of a region they leave for another pattern.
#pragma once

#include "rings/beading.hpp"

namespace filum::rings {

// The area where the lane coordinate is above `lane`: outer loops counter-clockwise, holes clockwise, none crossing.
// Arcs are off by at most `tolerance` mm.
Loops beyond(const Beading& beading, int lane, double tolerance);

} // namespace filum::rings
