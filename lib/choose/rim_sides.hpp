// The sides of a surface's rims.
#pragma once

#include "surface/surface.hpp"

namespace filum::choose {

using geom::Vec3;
using surface::Surface;

// A stretch of a rim, the surface to its left; all of it if both ends are one.
struct RimSide {
    Vec3 from, to;     // vertices
    double length = 0; // mm
};

// The longest stretches of all rims between corners, at most `most`; of equals the first.  A corner is where the rim
// turns by more than 30 degrees within a fortieth of its length each way, the sharpest place of each such turn.
std::vector<RimSide> longest_sides(const Surface& s, std::size_t most);

} // namespace filum::choose
