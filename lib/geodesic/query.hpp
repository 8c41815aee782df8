// What an exact field says between the vertices.
#pragma once

#include "geodesic/exact.hpp"

namespace filum::geodesic {

// The distance at point `p` of a triangle, mm: the least over all windows that can see it.
double distance_at(const Surface& surface, const ExactField& field, std::uint32_t triangle, const Vec3& p);

// Where the distance along half-edge `h` passes `level`: places between its ends, mm from its tail, ascending.  They
// are solved from the windows, not interpolated, and may be several.  Their number is even if the ends lie on the same
// side of the level (an end that has just the level counts as above it), else odd.
void level_crossings(const Surface& surface, const ExactField& field, std::uint32_t h, double level,
                     std::vector<double>& out);

// mm: the greatest distance at a vertex or on an edge; where fronts meet within a triangle it may be greater. What no
// source reaches does not count.
double farthest(const Surface& surface, const ExactField& field);

} // namespace filum::geodesic
