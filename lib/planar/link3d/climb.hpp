// Joins to a region on the layer above: a plain lift and a short jog, a ramp, or a turn of a helix.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Whether the front region is one layer above the nozzle: its rise is 0.5 to 1.5 layer heights.
bool rises(const State& state);

// The join from the nozzle, on the layer below, up to the front region. Nothing if the region is out of reach.
std::optional<Entry> climb(State& state);

} // namespace filum::link3d
