// A stroke with points dense enough for a varying tilt. Private to lib/motion/route.
#pragma once

#include "route/tilt.hpp"

namespace filum::route {

struct DensePoint {
    Vec3 tip, normal;
    Vec3 along;     // unit, perpendicular to the normal, transported without rotation about it; at first along
                    // the path
    double arc = 0; // mm from the stroke's start
    std::uint32_t before = 0;            // beads born earlier are obstacles
    bool near = false;                   // near a place where the head is blocked
    std::uint32_t span = 0, segment = 0; // the segment that it ends or divides; 0 for the first point of a span
    double share = 0;                    // position on that segment: 1 at its end
};

struct DenseStroke {
    std::vector<DensePoint> points; // of all spans; where two meet, both have one
};

// The points of the stroke, and additional points where it is within `reach` mm along it of a blocked segment.
DenseStroke densified(const Stroke& stroke, double reach, double spacing);

// The point's normal tilted by x rad towards `along` and by y rad to its left.
Vec3 tilted(const DensePoint& p, const geom::Vec2& tilt);

// The stroke's spans with these points and tilts.
TiltedStroke with_tilts(const DenseStroke& dense, const Stroke& stroke, const std::vector<geom::Vec2>& tilts);

} // namespace filum::route
