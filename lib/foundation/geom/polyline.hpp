// Lengths of polylines.
#pragma once

#include "geom/vec.hpp"

#include <span>
#include <vector>

namespace filum::geom {

// Length from the first point to the last, mm; 0 for fewer than two points.
template <class V>
double length_of(std::span<const V> line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
    return sum;
}
inline double length(std::span<const Vec2> line) { return length_of(line); }
inline double length(std::span<const Vec3> line) { return length_of(line); }

// Arc length of every point from the first one, mm.
template <class V>
std::vector<double> arc_lengths_of(std::span<const V> line) {
    std::vector<double> out(line.size(), 0);
    for (std::size_t i = 1; i < line.size(); ++i) out[i] = out[i - 1] + distance(line[i - 1], line[i]);
    return out;
}
inline std::vector<double> arc_lengths(std::span<const Vec2> line) { return arc_lengths_of(line); }
inline std::vector<double> arc_lengths(std::span<const Vec3> line) { return arc_lengths_of(line); }

} // namespace filum::geom
