// Windows: pieces of an edge that are reached from one source by straight lines in an unfolded strip of triangles.
// Private to lib/geodesic.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace filum::geodesic {

// In the frame of a half-edge: x along it from its tail, y to the left, into the triangle that the window is about to
// enter.  Two kinds:
//   a point source at (sx, sy), sy <= 0:  distance(x) = sigma + |(x, 0) - (sx, sy)|
//   a line source, sy > 0:                distance(x) = sigma + sx x, travelling along the unit vector (sx, sy)
struct Window {
    double b0, b1;      // mm, b0 < b1: the piece of the edge
    double sx, sy;      // source or direction
    double sigma;       // mm: distance at the source, or at the frame's origin
    std::uint32_t next; // of this half-edge, by ascending b0; kNone at the last
    bool pending;       // not yet propagated

    [[nodiscard]] bool is_line() const { return sy > 0; }
    [[nodiscard]] double at(double x) const {
        if (is_line()) return sigma + sx * x;
        const double dx = x - sx;
        return sigma + std::sqrt(dx * dx + sy * sy);
    }
};

// Where the distances of two windows are equal within (lo, hi): at most two places, ascending.
struct Crossings {
    int count = 0;
    double x[2] = {0, 0};
};
Crossings crossings(const Window& a, const Window& b, double lo, double hi);

} // namespace filum::geodesic
