// Surfaces and stresses to test with.
#pragma once

#include "stressfield/stencil.hpp"
#include "stressfield/stressfield.hpp"

#include <cmath>
#include <stdexcept>

namespace filum::stressfield {

// A square of side `size` in the plane z = 0, facing up, of n x n squares of two triangles each.
inline surface::Surface square(int n, double size) {
    mesh::Mesh m;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) m.vertices.push_back({size * i / n, size * j / n, 0});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const auto a = static_cast<std::uint32_t>(j * (n + 1) + i), up = static_cast<std::uint32_t>(n + 1);
            m.triangles.push_back({a, a + 1, a + up + 1});
            m.triangles.push_back({a, a + up + 1, a + up});
        }
    Notes notes;
    return surface::connect(std::move(m), notes);
}

// Numbers in [0, 1), the same on every machine.
struct Dice {
    std::uint32_t state = 12345;
    double operator()() {
        state = state * 1664525U + 1013904223U;
        return state / 4294967296.0;
    }
};

// What stencils make of the values `of` samples at vertex v.
inline double value(const Stencils& s, std::size_t v, const std::vector<double>& of) {
    double out = 0;
    for (std::uint32_t k = s.start[v]; k < s.start[v + 1]; ++k) out += s.weight[k] * of[s.sample[k]];
    return out;
}

inline const surface::Field& field(const surface::Sheet& s, const std::string& name) {
    for (const auto& f : s.fields)
        if (f.name == name) return f;
    throw std::runtime_error("no field " + name);
}

} // namespace filum::stressfield
