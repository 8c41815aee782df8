// Connects lanes: all of them into a spiral, where each leads to the next; others by exchanges, two at a time.
#pragma once

#include "surfpath/lanes/linked_lanes.hpp"
#include "surfpath/lanes/rungs.hpp"

namespace filum::surfpath::lanes {

// A ladder from `start` inwards (on its right) over as many lanes as possible, on which they run side by side for at
// least `least` mm, and hardly longer. Empty if there is no such place.
Ladder spiral_ladder(const Lanes& lanes, std::uint32_t start, double least);

// Leads each lane to the one `by` (1 or 2) further on, between the first and the last rung. By 1: a spiral from the
// first lane to the last. By 2: a double spiral whose two arms meet in a turn at the inner end, so that both ends of
// the curve lie on the first lanes.
// The inner end of a spiral moves to a ridge with turns of `radius` mm.
void shift(LinkedLanes& linked, const Lanes& lanes, const Ladder& rungs, int by, double radius);

// Joins all lanes of the ladder to one closed curve: a double spiral whose two arms meet in half turns at the first
// lanes and at the last ones. Unlike exchanges, which need two half turns for each pair of lanes, it has two in all.
// Half turns reach into the ladder by the share `into` of its length.
void wind_loop(LinkedLanes& linked, const Lanes& lanes, const Ladder& rungs, double into);

// Joins the remaining curves where possible, two lanes at a time, by exchanges where these run side by side, with
// turns of `radius` mm where there is room.
void exchange_lanes(LinkedLanes& linked, const Lanes& lanes, double radius);

} // namespace filum::surfpath::lanes
