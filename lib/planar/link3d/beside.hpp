// Joins to a neighbour on the same layer: to the next curve of a region, and from a brim to its region.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// A jog from the end of the brim straight to the nearest entry of the front region. Nothing if that is out of reach, or
// if a bead lies between.
std::optional<Entry> step_in(State& state);

// The way to the nearest curve of the front region that is not done: a jog if it is in reach and crosses nothing.
// Otherwise the nozzle stops and travels, and a note reports the break.
Entry hop(State& state, std::span<const char> done);

} // namespace filum::link3d
