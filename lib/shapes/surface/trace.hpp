// Projects polylines onto a surface.
#pragma once

#include "surface/section.hpp"

#include <span>

namespace filum::surface {

struct Trace {
    std::vector<Segment> segments; // in the order of the line, each beginning where the one before ends
    double off = 0;                // mm: greatest distance of a point from the surface
};

// The line through the points of the surface nearest to `points` (at least one); a point for a single one. Between
// consecutive points it is the section with the plane through both that is perpendicular to the surface at them.
// Throws Error(bad_input), naming the two points (from 1), if the surface ends between them, as may happen for points
// on a rim, or if they are on different components.
Trace trace(const Surface& s, std::span<const Vec3> points);

} // namespace filum::surface
