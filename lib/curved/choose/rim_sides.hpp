// Splits rims at corners into sides.
#pragma once

#include "surface/surface.hpp"

namespace filum::choose {

using geom::Vec3;
using surface::Surface;

// A stretch of a rim with the surface on its left; the whole rim if both ends are equal.
struct RimSide {
    Vec3 from, to;     // vertices
    double length = 0; // mm
};

// The longest stretches of all rims between corners, at most `most`; ties: the first. A corner is the sharpest place
// of a turn of more than 30 degrees within a fortieth of the rim's length on either side.
std::vector<RimSide> longest_sides(const Surface& s, std::size_t most);

} // namespace filum::choose
