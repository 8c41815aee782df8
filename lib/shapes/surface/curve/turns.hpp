// How tightly a path turns along a surface: the common measure of planners and metrics.
#pragma once

#include "geom/vec.hpp"

#include <span>
#include <vector>

namespace filum::surface::curve {

// spacings: a path that departs this much from another one to either side covers the same area, and turns as that one
// does.
inline constexpr double kRipple = 0.02;

// spacings: a radius below this is a kink. The turn from a line to its neighbour has half a spacing, and a tenth of
// that is for points that are not on the curve.
inline constexpr double kKinkRadius = 0.45;

// mm of path on either side of a place over which radii are measured that may be less than `radius` mm: a quarter of
// the spacing, but so much that a ripple of kRipple spacings does not count. Three points of such a ripple lie up to
// two kRipple spacings off a straight line; then the circle through them has a radius of reach^2 / (4 kRipple spacing).
double turn_reach(double radius, double spacing);

// A stretch of a path on which every place has less than some radius.
struct TightTurn {
    double from = 0, to = 0; // mm along the path
    double radius = 0;       // mm, the least on the stretch
    double at = 0;           // mm along the path to the place of that radius
};

// The radius at a place is that of the circle through it and the points `reach` mm of path before and after it,
// projected along the surface normal at the place. The two chords between them turn by an angle a, and the radius is
// reach / (2 sin(a / 2)). This measures geodesic curvature independently of the path's points. Corners of more than 90
// degrees have reach / 2, the least value. Places nearer than `reach` to an end have no radius. It is measured at steps
// of a fifth of the reach, and wherever one of the three points passes a point of the path.
// Returns the stretches with a radius below `radius`, in order. `normals`: of the surface, per point; of any length
// except 0.
std::vector<TightTurn> tight_turns(std::span<const geom::Vec3> points, std::span<const geom::Vec3> normals,
                                   double radius, double reach);

// mm: the sum of the lengths of all turns.
double length(std::span<const TightTurn> turns);

// mm: the least radius of the path; infinite if it is shorter than twice the reach.
double least_radius(std::span<const geom::Vec3> points, std::span<const geom::Vec3> normals, double reach);

} // namespace filum::surface::curve
