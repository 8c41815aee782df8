// Lanes: thin beads between the beads of a region, to where it can be left.
#pragma once

#include "link3d/state.hpp"

#include <functional>

namespace filum::link3d {

// Sees to it that the front region's last bead can be left, if there is a way: as it is, the other way round (`other`;
// the same for an open curve), or by the lane that is returned.
std::optional<std::vector<Vec2>> leave(State& state, std::uint32_t c, Bead& bead, const std::function<Bead()>& other);

void lay_lane(State& state, const std::vector<Vec2>& way);

} // namespace filum::link3d
