// Lines made gentle without leaving the surface.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surface::curve {

struct Ease {
    double radius = 0;      // mm: of the tightest turn to leave
    double corridor = 0;    // mm: no point moves farther than this
    double step = 0;        // mm: of the points of what is changed; 0: a tenth of the radius
    bool fixed_ends = true; // of an open line: its first and last `radius` mm stay
};

// The line with turns rounded that are tighter than the radius, on the surface: what turns more than that goes towards
// its inner side until it does not, or has moved by the corridor (curve shortening, but only by the curvature in
// excess; geodesic curvature counts, that of the surface does not).  What has not moved by 1e-4 mm stays as it was.
// Every point lies in its triangle, and changed stretches have points wherever they cross edges.
struct Eased {
    Line line;
    double moved = 0;     // mm: the most that a point moved
    double too_tight = 0; // mm: length of what still turns more than 1.05 / radius
};
Eased ease(const Surface& s, const Line& line, const Ease& options);

} // namespace filum::surface::curve
