// Triangulates plane polygons by ear clipping; private to lib/shapes/mesh.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace filum::mesh {

struct Ears {
    std::vector<std::array<std::uint32_t, 3>> triangles; // indices of points; two fewer triangles than points
    bool sound = true;                                   // false: the polygon crosses itself
};

// Triangulates a counter-clockwise polygon. It cuts off one corner at a time, the best shaped first, whose triangle
// contains no other corner. The polygon may touch itself in points and along edges. Points on straight sides become
// corners of triangles too.
Ears cut_ears(std::span<const geom::Vec2> polygon);

} // namespace filum::mesh
