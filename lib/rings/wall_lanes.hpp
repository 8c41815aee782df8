// How many lanes lie on each side of a wall's middle, and where that number changes.
#pragma once

#include "polygon/medial_axis.hpp"

namespace filum::rings {

using polygon::MedialAxis;

// On walls (pieces of the axis whose radius changes slowly) and at the tops (where it is largest) of a region.
struct WallLanes {
    MedialAxis axis;           // with nodes where the number of lanes changes
    std::vector<char> wall;    // per piece
    std::vector<char> set;     // per node: whether `lanes` is told: it lies on a wall, or is a top
    std::vector<double> lanes; // per node: a whole number, between two of them where one goes over into the other
};

// Widths: no lane is wider, nor narrower than one by this, to spare a change of their number.
inline constexpr double kWidest = 1.75;
inline constexpr double kMostOff = 1.0 / 8; // of its width: a bead that is off by less counts as where it should be
inline constexpr double kRamp = 3;          // widths of wall along which the number of lanes changes by one
// Slope of the radius along the axis above which two sides form a corner, not a wall: there the radius grows by a width
// within less than a ramp.  They meet at 39 degrees then.
inline constexpr double kWallSlope = 1 / kRamp;

// N lanes where the radius R is w sqrt(N (N - 1)) to w sqrt(N (N + 1)), so that lanes are wider and narrower than w by
// the same factor; at least one.  A change of N that is taken back within the length of a ramp is not made.  In ramps
// the number is the mean of the least function above N and the greatest below it that change by one in half a ramp.
WallLanes wall_lanes(const MedialAxis& axis, double width);

} // namespace filum::rings
