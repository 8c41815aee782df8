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

inline constexpr double kSharing = 2; // the inmost lanes on each side that share what a wall's thickness leaves over
// Widths: no lane is wider, nor narrower than one by this, to spare a change of their number.
inline constexpr double kWidest = 1.75;
inline constexpr double kRamp = 3;          // widths of wall along which the number of lanes changes by one
inline constexpr double kAppear = 1.0 / 16; // of a ramp: nodes are set where so much of one is passed

// N lanes where the radius R is w sqrt(N (N - 1)) to w sqrt(N (N + 1)), so that lanes are wider and narrower than w by
// the same factor; at least one.  A change of N that is taken back within the length of a ramp is not made.  In ramps
// the number is the mean of the least function above N and the greatest below it that change by one in half a ramp.
WallLanes wall_lanes(const MedialAxis& axis, double width);

} // namespace filum::rings
