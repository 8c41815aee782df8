// Exact distances between the vertices.
#pragma once

#include "geodesic/exact.hpp"

namespace filum::geodesic {

// The distance at point `p` of a triangle, mm: the least over all windows that can see it.
double distance_at(const Surface& surface, const ExactField& field, std::uint32_t triangle, const Vec3& p);

// Sets `out` to the places where the distance along half-edge `h` crosses `level`: mm from its tail, between its ends,
// ascending. They are solved from the windows rather than interpolated, and may be several: an even number if both
// ends are on the same side of the level (an end at the level counts as above), otherwise an odd one.
void level_crossings(const Surface& surface, const ExactField& field, std::uint32_t h, double level,
                     std::vector<double>& out);

// mm: the greatest distance at a vertex or on an edge; inside a triangle, on a ridge, it may be greater. Unreached
// components do not count.
double farthest(const Surface& surface, const ExactField& field);

} // namespace filum::geodesic
