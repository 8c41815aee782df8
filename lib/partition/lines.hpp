// Lines drawn onto a sheet, as edges of its triangles.
#pragma once

#include "partition/split.hpp"

namespace filum::partition {

// Makes the line through the places of the sheet nearest to `points` edges of its triangles, which are split for that,
// and sets `drawn` (per half-edge, either half; it grows along) on them.  From point to point it runs in the plane
// through both that stands upright on the surface; where it passes an edge within a twentieth of a vertex, it goes
// through that.  Returns how far the farthest point was from the surface, mm.  Lines and sources of the sheet go.
// Throws Error(bad_input) naming the two points (from 1) where the surface ends between them.  Precondition: a point.
double draw(Sheet& sheet, std::vector<char>& drawn, std::span<const Vec3> points);

// Appends the value between those of vertices a and b of a field, `share` of the way; vectors without their sign.
void append_between(surface::Field& f, std::uint32_t a, std::uint32_t b, double share);

} // namespace filum::partition
