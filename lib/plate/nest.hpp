// libnest2d behind plain data; private to lib/plate.  The library does not compile as C++20 (its Radians compare
// ambiguously), so nest.cpp is C++17, and so is this header.
#pragma once

#include <cstddef>
#include <vector>

namespace filum::plate {

// A convex polygon, counter-clockwise, mm.
struct Corners {
    std::vector<double> x, y;
};

struct Nested {
    std::vector<double> x, y;        // per polygon, how far it is moved, once turned, mm
    std::vector<int> quarters;       // per polygon, how many quarter turns to the left about (0, 0)
    std::vector<std::size_t> on_bed; // per polygon: 0 for the first bed, 1 for what found no place on it, and so on
};

// Places the polygons on beds of width x depth so that they touch but do not overlap; the largest first.  With
// `turn` all but the first may be turned by quarter turns, where that is most compact.  The same places for the same
// polygons.  No-fit polygons and a local search of the best place (libnest2d 5.0, T. Meszaros).
Nested nest(const std::vector<Corners>& polygons, double width, double depth, bool turn);

} // namespace filum::plate
