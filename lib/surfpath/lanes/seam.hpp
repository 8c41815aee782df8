// Where many lanes become one: all change over to the next, side by side.
#pragma once

#include "surfpath/lanes/rungs.hpp"
#include "surfpath/lanes/weave.hpp"

namespace filum::surfpath::lanes {

// Rungs over as many lanes as may be, from `start` inwards (on its right), where they run side by side for at least
// `least` mm, if they can for twice as long; empty if there is no such place.
Rungs seam_place(const Lanes& lanes, std::uint32_t start, double least);

// Each lane goes over to the one `by` (1 or 2) further on, from the first rung to the last.  By 1: one spiral, from the
// first lane to the last.  By 2: two, side by side, of which the inner ends turn back into each other: both ends of the
// curve lie on the first lanes.
void shift(Weave& weave, const Lanes& lanes, const Rungs& rungs, int by);

// Joins all that the weave has left apart and that can be, two lanes at a time that change over into each other where
// they run side by side, with turns of `radius` mm where there is room.  `merged`: lanes that are one already.
void cross_over(Weave& weave, const Lanes& lanes, const std::vector<std::uint32_t>& merged, double radius);

} // namespace filum::surfpath::lanes
