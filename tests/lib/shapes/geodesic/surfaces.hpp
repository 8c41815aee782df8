// Surfaces by rule, with distances that are known, for the tests of geodesic.
#pragma once

#include "geodesic/exact.hpp"
#include "surface/surface.hpp"

#include <functional>
#include <numbers>
#include <random>

namespace surfaces {

using filum::geom::Vec2;
using filum::geom::Vec3;
using filum::surface::Surface;

inline Surface make(std::vector<Vec3> vertices, std::vector<filum::mesh::Triangle> triangles) {
    filum::Notes notes;
    return filum::surface::connect({std::move(vertices), std::move(triangles)}, notes);
}

// The rectangle [0, a] x [0, b] in n x m cells, inner vertices moved at random, diagonals at random, put into space by
// `lift`; cells for which `hole` holds are left out.
struct Sheet {
    Surface surface;
    std::vector<Vec2> flat; // per vertex of the surface
};
inline Sheet sheet(
    double a, double b, int n, int m, unsigned seed,
    const std::function<Vec3(Vec2)>& lift =
        [](Vec2 p) {
            return Vec3{p.x, p.y, 0};
        },
    const std::function<bool(int, int)>& hole = [](int, int) { return false; }) {
    std::mt19937 random(seed);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<Vec2> flat;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i <= n; ++i) {
            const double dx = unit() - 0.5, dy = unit() - 0.5;
            flat.push_back(
                {a * (i + (i > 0 && i < n ? 0.5 * dx : 0)) / n, b * (j + (j > 0 && j < m ? 0.5 * dy : 0)) / m});
        }
    std::vector<filum::mesh::Triangle> triangles;
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const bool rising = unit() < 0.5;
            if (hole(i, j)) continue;
            if (rising)
                triangles.insert(triangles.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                   {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
            else
                triangles.insert(triangles.end(), {{at(i, j), at(i + 1, j), at(i, j + 1)},
                                                   {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}});
        }
    std::vector<char> used(flat.size(), 0);
    for (const auto& t : triangles)
        for (const auto v : t) used[v] = 1;
    Sheet out;
    std::vector<Vec3> vertices;
    std::vector<std::uint32_t> to(flat.size());
    for (std::size_t v = 0; v < flat.size(); ++v) {
        if (used[v] == 0) continue;
        to[v] = static_cast<std::uint32_t>(vertices.size());
        vertices.push_back(lift(flat[v]));
        out.flat.push_back(flat[v]);
    }
    for (auto& t : triangles) t = {to[t[0]], to[t[1]], to[t[2]]};
    out.surface = make(std::move(vertices), std::move(triangles));
    return out;
}

inline Surface cube(double size) {
    std::vector<Vec3> v;
    for (int i = 0; i < 8; ++i)
        v.push_back({(i & 1) != 0 ? size : 0, (i & 2) != 0 ? size : 0, (i & 4) != 0 ? size : 0});
    return make(v, {{0, 2, 1},
                    {1, 2, 3},
                    {4, 5, 6},
                    {5, 7, 6},
                    {0, 1, 4},
                    {1, 5, 4},
                    {2, 6, 3},
                    {3, 6, 7},
                    {0, 4, 2},
                    {2, 4, 6},
                    {1, 3, 5},
                    {3, 7, 5}});
}

// An octahedron, every triangle split in four `depth` times, on a sphere of radius 1 whose points are moved by up to
// `noise` outwards or inwards.
inline Surface bumpy_sphere(int depth, double noise, unsigned seed) {
    std::vector<Vec3> v{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<filum::mesh::Triangle> all{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                           {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int d = 0; d < depth; ++d) {
        std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> made;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto key = std::pair{std::min(a, b), std::max(a, b)};
            for (const auto& [k, id] : made)
                if (k == key) return id;
            const Vec3 m = v[a] + v[b];
            v.push_back(1 / norm(m) * m);
            made.push_back({key, static_cast<std::uint32_t>(v.size() - 1)});
            return made.back().second;
        };
        std::vector<filum::mesh::Triangle> finer;
        for (const auto& [a, b, c] : all) {
            const auto p = middle(a, b), q = middle(b, c), r = middle(c, a);
            finer.insert(finer.end(), {{a, p, r}, {p, b, q}, {r, q, c}, {p, q, r}});
        }
        all = std::move(finer);
    }
    std::mt19937 random(seed);
    for (Vec3& p : v) p = (1 + noise * (2 * (static_cast<double>(random()) / 4294967296.0) - 1)) * p;
    return make(std::move(v), std::move(all));
}

} // namespace surfaces
