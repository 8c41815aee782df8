// Numbers of lanes that change for a short stretch only.  Private to lib/rings.
#pragma once

#include "rings/axis.hpp"
#include "rings/wall_lanes.hpp"

namespace filum::rings {

// `lanes` per piece of the axis (of walls; others do not count), without stretches that have more lanes, or fewer, than
// all walls next to them, and are shorter than a ramp.  They stay where lanes would become too wide or too narrow.
std::vector<int> without_short_changes(const Axis& axis, const std::vector<char>& wall, std::vector<int> lanes,
                                       const WallLaneOptions& options);

} // namespace filum::rings
