// Joins to regions that do not lie above the last one: connectors and strands, which are not part of the product.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// A connector around everything printed, to the extreme place of the front region with the shortest way. It runs close
// to the part, or as far away as the head is wide if the head needs the room to come down. Nothing if there is no such
// way.
std::optional<Entry> go_around(State& state);

// A straight strand to the front region, if that is on the nozzle's layer and the strand crosses nothing. Nothing
// otherwise.
std::optional<Entry> go_inside(State& state);

// Whether a straight way leads from p, on the front region's layer, out of the part or to the next region. It must
// cross nothing of `own`.
bool sees_outside(const State& state, Vec2 p, const SegmentIndex& own);

} // namespace filum::link3d
