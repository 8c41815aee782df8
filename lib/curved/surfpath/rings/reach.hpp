// An upper bound on the area that rings of a least radius can cover (docs/algorithms/bounds.md, "How much rings can
// cover").
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rings {

using geom::Vec3;
using surface::Surface;

struct RingBound {
    double surface = 0;   // mm2
    double reached = 0;   // mm2, upper bound
    std::size_t dead = 0; // dead ends with a triangle that is out of reach as a whole
    double largest = 0;   // mm2 out of reach in the largest dead end
    Vec3 at;              // a place there

    [[nodiscard]] double share() const { return surface > 0 ? reached / surface : 1; }
};

// Bounds the area within half a spacing of any closed line that keeps half a spacing from the rims and whose geodesic
// curvature is at most 1 / radius. Such a line can be anywhere except in dead ends: pieces in which no disc of the
// radius has room and which are connected to the rest along one stretch at most. Where the surface is curved like a
// sphere, discs are as much smaller as circles of that geodesic curvature are there. Ties for the largest dead end:
// the one with the first triangle.
RingBound ring_bound(const Surface& s, double spacing, double radius);

// Adds the fact "rings-bound", a share, and the note NoteCode::area_out_of_rings if more than 1 % of the surface is
// out of reach.
void report_ring_bound(const RingBound& reach, plan::Plan& plan);

} // namespace filum::surfpath::rings
