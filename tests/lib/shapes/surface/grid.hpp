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

// The rectangle itself, at z 0.
inline mesh::Mesh flat_grid(double a, double b, int n, int m) {
    return grid(a, b, n, m, [](geom::Vec2 p) { return geom::Vec3{p.x, p.y, 0}; });
}

// As grid(), without the cells in whose middle `hole` holds.
inline mesh::Mesh pierced_grid(double a, double b, int n, int m, const std::function<geom::Vec3(geom::Vec2)>& lift,
                               const std::function<bool(geom::Vec2)>& hole) {
    constexpr auto none = ~std::uint32_t{0};
    mesh::Mesh out;
    std::vector<std::uint32_t> number(static_cast<std::size_t>((n + 1) * (m + 1)), none);
    const auto vertex = [&](int i, int j) {
        const int at = j * (n + 1) + i;
        auto& v = number[static_cast<std::size_t>(at)];
        if (v == none) {
            v = static_cast<std::uint32_t>(out.vertices.size());
            out.vertices.push_back(lift({a * i / n, b * j / m}));
        }
        return v;
    };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            if (hole({a * (i + 0.5) / n, b * (j + 0.5) / m})) continue;
            const auto p = vertex(i, j), q = vertex(i + 1, j), r = vertex(i + 1, j + 1), s = vertex(i, j + 1);
            out.triangles.push_back({p, q, r});
            out.triangles.push_back({p, r, s});
        }
    return out;
}

} // namespace filum::surface
