// The number of lanes on each side of a wall's middle.
#pragma once

#include "polygon/medial_axis.hpp"

namespace filum::fill::rings {

using polygon::MedialAxis;

// The number of lanes on walls (pieces of the axis whose radius changes slowly) and at the tops (local maxima of the
// radius) of a region.
struct WallLanes {
    MedialAxis axis;           // with nodes where the number of lanes changes
    std::vector<char> wall;    // per piece
    std::vector<char> set;     // per node: whether `lanes` is defined, as the node belongs to a wall or is a top
    std::vector<double> lanes; // per node: a whole number, or between two of them in ramps
};

// Widths: lanes are at most this wide, and at least 1 over this, where a short change of their number is avoided.
inline constexpr double kWidest = 1.75;
inline constexpr double kMostOff = 1.0 / 8; // widths: smaller deviations of a bead do not count
inline constexpr double kRamp = 3;          // widths of wall along which the number of lanes changes by one
// Slope of the radius along the axis above which the two sides form a corner rather than a wall: the radius grows by a
// width in less than a ramp. The sides then meet at 39 degrees.
inline constexpr double kWallSlope = 1 / kRamp;

// N lanes where the radius R is from w sqrt(N (N - 1)) to w sqrt(N (N + 1)), so that the widest and the narrowest
// lanes differ from w by the same factor; at least one. A change of N that is reversed within the length of a ramp is
// not made. In ramps the number is the mean of the least function above N and the greatest below it that change by one
// per half ramp.
WallLanes wall_lanes(const MedialAxis& axis, double width);

} // namespace filum::fill::rings
