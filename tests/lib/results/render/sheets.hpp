// Surfaces for the tests of pictures.
#pragma once

#include "surface/sheet.hpp"

#include <cmath>
#include <numbers>

namespace filum::render {

using geom::Vec3;

// [0, 10] x [0, 10] at height z in n x n squares, facing up or down.
inline void add_square(mesh::Mesh& m, std::uint32_t n, double z = 0, bool up = true) {
    const auto first = static_cast<std::uint32_t>(m.vertices.size());
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) m.vertices.push_back({10.0 * i / n, 10.0 * j / n, z});
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return first + j * (n + 1) + i; };
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i)
            for (mesh::Triangle t : {mesh::Triangle{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                     mesh::Triangle{at(i, j), at(i + 1, j + 1), at(i, j + 1)}}) {
                if (!up) std::swap(t[1], t[2]);
                m.triangles.push_back(t);
            }
}

inline surface::Sheet sheet_of(mesh::Mesh m) {
    Notes notes;
    return {surface::connect(std::move(m), notes), {}, {}};
}

inline surface::Sheet square(std::uint32_t n = 1) {
    mesh::Mesh m;
    add_square(m, n);
    return sheet_of(std::move(m));
}

inline surface::Sheet sphere(double r) {
    mesh::Mesh m;
    constexpr std::uint32_t kAround = 60, kUp = 30;
    for (std::uint32_t j = 0; j <= kUp; ++j)
        for (std::uint32_t i = 0; i < kAround; ++i) {
            const double a = 2 * std::numbers::pi * i / kAround, b = std::numbers::pi * (1.0 * j / kUp - 0.5);
            m.vertices.push_back({r * std::cos(b) * std::cos(a), r * std::cos(b) * std::sin(a), r * std::sin(b)});
        }
    const auto at = [](std::uint32_t i, std::uint32_t j) {
        return j == 0 ? 0 : j == kUp ? kUp * kAround : j * kAround + i % kAround;
    };
    for (std::uint32_t j = 0; j < kUp; ++j)
        for (std::uint32_t i = 0; i < kAround; ++i) {
            if (j > 0) m.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (j + 1 < kUp) m.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return sheet_of(std::move(m));
}

} // namespace filum::render
