// A triangle mesh: shared vertices, three indices per triangle.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace filum::mesh {

using geom::Vec3;

struct Mesh {
    std::vector<Vec3> vertices;                          // mm
    std::vector<std::array<std::uint32_t, 3>> triangles; // counter-clockwise seen from outside
};

} // namespace filum::mesh
