// Removes short changes of the number of lanes. Private to lib/planar/fill/rings.
#pragma once

#include "polygon/medial_axis.hpp"

#include <vector>

namespace filum::fill::rings {

using polygon::MedialAxis;

// `lanes` per piece of the axis (walls only). Stretches shorter than a ramp with more lanes, or fewer, than all
// neighbouring walls get the number of these, unless lanes would become too wide or too narrow.
std::vector<int> without_short_changes(const MedialAxis& axis, const std::vector<char>& wall, std::vector<int> lanes,
                                       double width);

} // namespace filum::fill::rings
