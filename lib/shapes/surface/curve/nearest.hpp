// The place of a line nearest to a point in space.
#pragma once

#include "surface/curve/line.hpp"

#include <limits>

namespace filum::surface::curve {

struct NearestWay {
    double distance = std::numeric_limits<double>::infinity(); // mm
    double way = 0;                                            // mm along the line
};

// The nearest place on the line; `ways` are its arc lengths. Ties: the first segment. Infinitely far if there is none.
NearestWay nearest(const Line& line, std::span<const double> ways, const Vec3& p);

// The nearest place on the two segments that meet at point `i` of a closed line.
NearestWay nearest_beside(const Line& line, std::span<const double> ways, const Vec3& p, std::size_t i);

} // namespace filum::surface::curve
