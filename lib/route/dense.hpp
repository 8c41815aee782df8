// A stroke with points close enough to let the tool lean; private to lib/route.
#pragma once

#include "route/tilt.hpp"

namespace filum::route {

struct Point {
    Vec3 tip, normal;
    Vec3 along;               // unit, across the normal: does not turn about it on the way; the path's way at first
    double arc = 0;           // mm from the stroke's beginning
    std::uint32_t before = 0; // beads that stand in the way
    bool near = false;        // to where the head is blocked
    std::uint32_t span = 0, segment = 0; // the segment it ends or cuts; of a span's first point, 0
    double share = 0;                    // of that segment: 1 at its end
};

struct Dense {
    std::vector<Point> points; // of all spans: where two meet, both have one
};

// Points of the stroke, and more where it is no farther along it than `reach` mm from a blocked segment.
Dense densified(const Stroke& stroke, double reach, double spacing);

// The point's normal, leant: by x towards `along`, by y to its left; rad.
Vec3 leant(const Point& p, const geom::Vec2& tilt);

// The stroke's spans with these points and tilts.
Leant put(const Dense& dense, const Stroke& stroke, const std::vector<geom::Vec2>& tilts);

} // namespace filum::route
