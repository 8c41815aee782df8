// How much of a surface rings can cover that bend no tighter than a radius (docs/algorithms/bounds.md, "How much
// rings can cover").
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rings {

using geom::Vec3;
using surface::Surface;

struct Reach {
    double surface = 0;   // mm2
    double reached = 0;   // mm2, at most
    std::size_t dead = 0; // dead ends with a triangle that is out of reach all over
    double largest = 0;   // mm2 out of reach in one of them,
    Vec3 at;              // and a place there

    [[nodiscard]] double share() const { return surface > 0 ? reached / surface : 1; }
};

// The part of the surface within half a spacing of any closed line that keeps half a spacing from the rims and bends no
// tighter than `radius`, along the surface.  A bound: such a line may be anywhere but in dead ends, pieces where no
// disc of the radius has room and that lie open to the others, if at all, along one stretch.  Where the surface is bent
// like a ball, discs are as much smaller as circles of that curvature are there. What dead ends hold is told with the
// largest, of equals the one with the first triangle.
Reach reach(const Surface& s, double spacing, double radius);

// Adds that to the plan: the fact "rings-bound", a share, and the note NoteCode::area_out_of_rings if
// that is more than 1 % of the surface.
void tell_reach(const Reach& reach, plan::Plan& plan);

} // namespace filum::surfpath::rings
