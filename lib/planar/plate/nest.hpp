// Wraps libnest2d behind plain data; private to lib/planar/plate. The library does not compile as C++20 (its Radians
// compare ambiguously), so nest.cpp and this header are C++17.
#pragma once

#include <cstddef>
#include <vector>

namespace filum::plate {

// A convex polygon, counter-clockwise, mm.
struct Corners {
    std::vector<double> x, y;
};

struct Nesting {
    std::vector<double> x, y;        // mm, per polygon: its move after the turn
    std::vector<int> quarters;       // per polygon: its quarter turns to the left about (0, 0)
    std::vector<std::size_t> on_bed; // per polygon: 0 on the first bed, 1 on the next, and so on
};

// Places the polygons on beds of width x depth mm, the largest first, so that they touch but do not overlap. With
// `turn`, all but the first may be rotated by quarter turns where that is more compact. Equal input gives equal places.
// Uses no-fit polygons and a local search for the best place (libnest2d 5.0, T. Meszaros).
Nesting nest(const std::vector<Corners>& polygons, double width, double depth, bool turn);

} // namespace filum::plate
