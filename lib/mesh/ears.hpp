// Polygons of the plane, cut into triangles by ears; private to lib/mesh.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace filum::mesh {

struct Ears {
    std::vector<std::array<std::uint32_t, 3>> triangles; // two fewer than points; numbers of points
    bool sound = true;                                   // false: the polygon crosses itself
};

// Cuts off corners one after the other, the best shaped first, each with no other corner in its triangle.  The polygon
// runs counter-clockwise; it may touch itself in points and along edges.  Points on straight sides are corners of
// triangles as well.
Ears cut_ears(std::span<const geom::Vec2> polygon);

} // namespace filum::mesh
