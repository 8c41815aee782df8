// Open lines through points.
#pragma once

#include "geom/vec.hpp"

#include <span>

namespace filum::geom {

// mm from the first point to the last; 0 for fewer than two.
inline double length(std::span<const Vec2> line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += distance(line[i], line[i + 1]);
    return sum;
}
inline double length(std::span<const Vec3> line) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) sum += distance(line[i], line[i + 1]);
    return sum;
}

} // namespace filum::geom
