// What was laid of a region, as machines round it.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Puts what was laid of the front region on the grid and parts what crosses there.  Its first point stays: the nozzle
// is there.  Joins that cross a bead all the same are told.
void settle(State& state);

} // namespace filum::link3d
