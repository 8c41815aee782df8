// Surfaces over a rectangle.
#pragma once

#include "mesh/mesh.hpp"

#include <functional>

namespace filum::surface {

// [0, a] x [0, b] in n x m cells, each in two triangles, put into space.
inline mesh::Mesh grid(double a, double b, int n, int m, const std::function<geom::Vec3(geom::Vec2)>& lift) {
    mesh::Mesh out;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) out.vertices.push_back(lift({a * i / n, b * j / m}));
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const auto at = static_cast<std::uint32_t>(j * (n + 1) + i), up = at + static_cast<std::uint32_t>(n) + 1;
            out.triangles.push_back({at, at + 1, up + 1});
            out.triangles.push_back({at, up + 1, up});
        }
    return out;
}

} // namespace filum::surface
