// Numbers of lanes that change for a short stretch only.  Private to lib/rings.
#pragma once

#include "polygon/medial_axis.hpp"

#include <vector>

namespace filum::rings {

using polygon::MedialAxis;

// `lanes` per piece of the axis (of walls; others do not count), without stretches that have more lanes, or fewer, than
// all walls next to them, and are shorter than a ramp.  They stay where lanes would become too wide or too narrow.
std::vector<int> without_short_changes(const MedialAxis& axis, const std::vector<char>& wall, std::vector<int> lanes,
                                       double width);

} // namespace filum::rings
