// How tightly a path turns along a surface: the common measure of planners and metrics.
#pragma once

#include "geom/vec.hpp"

#include <span>
#include <vector>

namespace filum::surface::curve {

inline constexpr double kTurnReach = 0.25; // mm of path on either side over which a turn is measured

// A stretch of a path on which every place has less than some radius.
struct TightTurn {
    double from = 0, to = 0; // mm along the path
    double radius = 0;       // mm, the least on the stretch
    double at = 0;           // mm along the path to the place of that radius
};

// The radius at a place is that of the circle through it and the points kTurnReach mm of path before and after it,
// projected along the surface normal at the place. This measures geodesic curvature independently of the path's
// points. A corner of angle a has radius kTurnReach / (2 sin(a / 2)); corners of more than 90 degrees have kTurnReach
// / 2, the least value. Places nearer than kTurnReach to an end have none. It is measured at steps of a fifth of the
// reach and wherever one of the three points passes a point of the path.
// Returns the stretches with a radius below `radius`, in order. `normals`: of the surface, per point; of any length
// except 0.
std::vector<TightTurn> tight_turns(std::span<const geom::Vec3> points, std::span<const geom::Vec3> normals,
                                   double radius);

// mm: the least radius of the path; infinite if it is shorter than twice the reach.
double least_radius(std::span<const geom::Vec3> points, std::span<const geom::Vec3> normals);

} // namespace filum::surface::curve
