// Surfaces with known directions.
#pragma once

#include "../../shapes/surface/grid.hpp"
#include "geom/angle.hpp"
#include "partition/partition.hpp"

#include <cmath>
#include <functional>
#include <map>

namespace filum::partition {

using geom::Vec2;

using geom::kDegree;

// [0, a] x [0, b] in n x m cells, each in two triangles, put into space.
inline Sheet grid(double a, double b, int n, int m, const std::function<Vec3(Vec2)>& lift) {
    Notes notes;
    Sheet sheet;
    sheet.surface = surface::connect(surface::grid(a, b, n, m, lift), notes);
    return sheet;
}

// A ball: an octahedron, its triangles split in four `rounds` times.
inline Sheet ball(double radius, int rounds) {
    mesh::Mesh m{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
                 {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (; rounds > 0; --rounds) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middle;
        const auto between = [&](std::uint32_t a, std::uint32_t b) {
            const auto [at, fresh] = middle.emplace(std::minmax(a, b), static_cast<std::uint32_t>(m.vertices.size()));
            if (fresh) m.vertices.push_back(m.vertices[a] + m.vertices[b]);
            return at->second;
        };
        std::vector<mesh::Triangle> finer;
        for (const auto& [a, b, c] : m.triangles) {
            const std::uint32_t ab = between(a, b), bc = between(b, c), ca = between(c, a);
            for (const mesh::Triangle& t : {mesh::Triangle{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}})
                finer.push_back(t);
        }
        m.triangles = std::move(finer);
        for (Vec3& v : m.vertices) v = 1 / norm(v) * v;
    }
    for (Vec3& v : m.vertices) v = radius * v;
    Notes notes;
    Sheet sheet;
    sheet.surface = surface::connect(std::move(m), notes);
    return sheet;
}

inline Vec3 flat(Vec2 p) { return {p.x, p.y, 0}; }

// Adds stress.NAME.s1 and .d1: at each vertex the vector's length and direction.
inline void add_stress(Sheet& sheet, const std::string& name, const std::function<Vec3(Vec3)>& pulled) {
    surface::Field s{"stress." + name + ".s1", {}, 1}, d{"stress." + name + ".d1", {}, 3};
    for (const Vec3& p : sheet.surface.vertices) {
        const Vec3 v = pulled(p);
        const double length = norm(v);
        const Vec3 u = length > 0 ? 1 / length * v : Vec3{1, 0, 0};
        s.values.push_back(length);
        d.values.insert(d.values.end(), {u.x, u.y, u.z});
    }
    sheet.fields.push_back(s);
    sheet.fields.push_back(d);
}

inline double total(const std::vector<Sheet>& patches) {
    double sum = 0;
    for (const auto& p : patches) sum += surface::area(p.surface);
    return sum;
}

inline Vec3 middle(const Surface& s, std::uint32_t t) {
    const auto& [a, b, c] = s.triangles[t];
    return 1.0 / 3 * (s.vertices[a] + s.vertices[b] + s.vertices[c]);
}

} // namespace filum::partition
