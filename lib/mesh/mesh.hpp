// A triangle mesh: shared vertices, three indices per triangle.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace filum::mesh {

using geom::Vec3;
using Triangle = std::array<std::uint32_t, 3>;

struct Mesh {
    std::vector<Vec3> vertices;         // mm
    std::vector<Triangle> triangles;    // counter-clockwise seen from outside
    std::vector<std::uint32_t> faces{}; // per triangle, the CAD face that it stands for, from 1; none: not known
};

} // namespace filum::mesh
