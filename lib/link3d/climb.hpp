// To a region on the layer above: a plain lift and a short jog, or a ramp.
#pragma once

#include "link3d/state.hpp"

namespace filum::link3d {

// Whether the front region lies on the layer that the nozzle is on.
bool rises(const State& state);

// To the front region, from where the nozzle is on the layer below; nothing if that is out of reach.
std::optional<Entry> climb(State& state);

} // namespace filum::link3d
