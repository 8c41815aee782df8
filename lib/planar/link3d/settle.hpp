// Rounds the spans of a region to the grid of machine programs, and separates beads that would cross there.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Rounds the points of the front region's spans to the grid and moves points so that no bead crosses another one.
// Segments of the region's curves, which are on the grid already, are not compared with each other. The first point
// stays, because the nozzle is there. A note reports joins that still cross a bead.
void settle(State& state);

} // namespace filum::link3d
