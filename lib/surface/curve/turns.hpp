// How tightly a path turns along a surface: one measure for whoever lays paths and whoever judges them.
#pragma once

#include "geom/vec.hpp"

#include <span>
#include <vector>

namespace filum::surface::curve {

inline constexpr double kTurnReach = 0.25; // mm of path each way that a turn is measured over

// A stretch of a path within which every place turns within less than some radius.
struct TightTurn {
    double from = 0, to = 0; // mm along the path
    double radius = 0;       // mm, the least in it
    double at = 0;           // mm along the path, where that is
};

// The radius of turning at places of the path, a fifth of the reach apart and wherever one of the three points passes a
// point of the path, is that of the circle through the place and
// those kTurnReach mm of path before and behind it, as they lie seen along the surface's normal at the place: geodesic
// curvature, whatever the points of the path are.  A corner of angle a has a radius of kTurnReach / (2 sin(a / 2)); of
// more than 90 degrees kTurnReach / 2, which is the least there is.  Nearer to the ends than the reach nothing turns.
//
// The stretches where it is less than `radius`, in order.  `normals`: of the surface, per point; of any length but 0.
std::vector<TightTurn> tight_turns(std::span<const geom::Vec3> points, std::span<const geom::Vec3> normals,
                                   double radius);

// mm: the least radius of turning anywhere; infinite for a path shorter than twice the reach.
double least_radius(std::span<const geom::Vec3> points, std::span<const geom::Vec3> normals);

} // namespace filum::surface::curve
