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

struct WallLaneOptions {
    double width = 0.4;   // mm
    double sharing = 2;   // the inmost lanes that share the rest of a wall's thickness
    double widest = 1.75; // widths: no lane is wider, nor narrower than one by this, to spare a change of their number
    double ramp = 1.2;    // mm of wall along which their number changes by one
    double appear = 0.1;  // of a ramp: nodes are set where so much of one is passed
    double slope = 0.5;   // of the radius, at most, of a wall
    double blend = 0.8;   // mm of a corner from a wall on that get nodes
};

// N lanes where the radius R is w sqrt(N (N - 1)) to w sqrt(N (N + 1)), so that lanes are wider and narrower than w by
// the same factor; at least one.  A change of N that is taken back within the length of a ramp is not made.  In ramps
// the number is the mean of the least function above N and the greatest below it that change by one in half a ramp.
WallLanes wall_lanes(const MedialAxis& axis, const WallLaneOptions& options);

} // namespace filum::rings
