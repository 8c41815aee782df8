// Operations on outlines, done apart for loops that do not come near each other.
#pragma once

#include "polygon/tiles.hpp"

namespace filum::polygon {

// The result of `operation` for `inputs`, computed apart for each cluster: loops of any input that come within `reach`
// mm of each other, directly or over others. The other loops count for a cluster only by how often they wind around it.
// That number is the same everywhere in the cluster, since they do not come near, so frames around it take their place.
// Concentric tubes are the case that gains most: a scan line of the whole crosses all of them, one of a cluster only
// its own. Up to some two thousand points, and for a single loop, the operation is done in one piece. The result of a
// cluster must lie within `reach` mm of it.
Loops clustered(std::span<const Loops> inputs, double reach, const Operation& operation);

} // namespace filum::polygon
