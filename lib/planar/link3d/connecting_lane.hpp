// Connecting lanes: thin beads between the beads of a region, to a place where the region can be left.
#pragma once

#include "link3d/state.hpp"

#include <functional>

namespace filum::link3d {

// Makes sure that the next region can be reached from the end of the front region's last bead, if there is a way.
// Returns a lane if one is needed. Otherwise the bead stays, or is replaced by `other()`, the same curve in the other
// direction (an open curve gives itself).
std::optional<std::vector<Vec2>> leave(State& state, std::uint32_t c, Bead& bead, const std::function<Bead()>& other);

// Prints a thin bead along `way`, on the front region's layer.
void lay_lane(State& state, const std::vector<Vec2>& way);

} // namespace filum::link3d
