// Inserts lines into a sheet as edges of its triangles.
#pragma once

#include "partition/split.hpp"

namespace filum::partition {

// Makes the line through the places of the sheet nearest to `points` (at least one) edges of its triangles, which are
// split, and marks these in `drawn` (per half-edge, either half; it is extended). Between points the line is in the
// plane through both that is perpendicular to the surface; where it crosses an edge within a twentieth of a vertex, it
// passes through the vertex. Returns the greatest distance of a point from the surface, mm. Isolines and sources of
// the sheet are removed.
// Throws Error(bad_input), naming the two points (from 1), if the surface ends between them.
double draw(Sheet& sheet, std::vector<char>& drawn, std::span<const Vec3> points);

// Appends the interpolated value between vertices a and b of a field, `share` of the way; vectors as directions
// without sign.
void append_between(surface::Field& f, std::uint32_t a, std::uint32_t b, double share);

} // namespace filum::partition
