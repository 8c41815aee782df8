// Lines drawn onto a surface.
#pragma once

#include "surface/section.hpp"

#include <span>

namespace filum::surface {

struct Trace {
    std::vector<Segment> segments; // in the order of the line, each beginning where the one before ends
    double off = 0;                // mm: how far the farthest point was from the surface
};

// The line through the points of the surface that are nearest to `points`; a point if there is only one.  From each to
// the next it runs in the plane through both that stands upright on the surface at its ends.
// Throws Error(bad_input) naming the two points (from 1) where the surface ends between them, as it may for points that
// both lie on a rim, or where they lie on different parts of it.  Precondition: a point.
Trace trace(const Surface& s, std::span<const Vec3> points);

} // namespace filum::surface
