// To what lies beside, on the same layer: the next curve of a region, a region from its brim.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// From the brim, where its last bead ends, straight over to the front region's nearest bead; nothing if that is out of
// reach, or a bead lies between.
std::optional<Entry> step_in(State& state);

// From one curve of the front region to the nearest one that is left: a jog, else a stop, which is told.
Entry hop(State& state, std::span<const char> done);

} // namespace filum::link3d
