// A triangle mesh: shared vertices, three indices per triangle.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace filum::mesh {

using geom::Vec3;
using Triangle = std::array<std::uint32_t, 3>;

inline constexpr std::uint32_t kNoVertex = ~std::uint32_t{0};

struct Mesh {
    std::vector<Vec3> vertices;         // mm
    std::vector<Triangle> triangles;    // counter-clockwise seen from outside
    std::vector<std::uint32_t> faces{}; // per triangle, the CAD face that it stands for, from 1; none: not known
    // Per vertex of the file: the vertex that it is here, kNoVertex if it is none; empty if all are as in the file.
    std::vector<std::uint32_t> of_file{};

    // Keeps of_file right where vertex v of those before becomes to[v]; the caller changes vertices and triangles.
    void renumber(const std::vector<std::uint32_t>& to) {
        if (of_file.empty()) {
            of_file = to;
            return;
        }
        for (std::uint32_t& v : of_file)
            if (v != kNoVertex) v = to[v];
    }
};

} // namespace filum::mesh
