// Rounds tight turns of lines on a surface.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surface::curve {

struct EaseOptions {
    double radius = 0;      // mm: radius of the tightest turn that may remain
    double corridor = 0;    // mm: greatest movement of a point
    double step = 0;        // mm between points of changed parts; 0: a tenth of the radius
    bool fixed_ends = true; // whether the first and last `radius` mm of an open line stay
};

// Rounds the turns of the line that are tighter than the radius: points move towards the inside of the turn until its
// curvature is low enough or they have moved by the corridor (curve shortening, driven by the excess of geodesic
// curvature only). Parts that moved by less than 1e-4 mm stay exactly as they were. Every point is in its triangle;
// changed parts have points where they cross edges.
struct EaseResult {
    Line line;
    double moved = 0;     // mm: greatest movement of a point
    double too_tight = 0; // mm of line whose curvature still exceeds 1.05 / radius
};
EaseResult ease(const Surface& s, const Line& line, const EaseOptions& options);

} // namespace filum::surface::curve
