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
    std::vector<std::uint32_t> faces{}; // per triangle: its CAD face, counted from 1; empty: unknown
    // Per vertex of the file: its vertex in this mesh, or kNoVertex if it was dropped. Empty if the vertices are those
    // of the file.
    std::vector<std::uint32_t> of_file{};

    // Updates of_file after a renumbering in which vertex v becomes to[v]. The caller changes vertices and triangles.
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
