// Surfaces whose lines can be counted by hand, measured.
#pragma once

#include "baselines/kipping2022/kipping2022.hpp"
#include "geodesic/measure.hpp"
#include "geodesic/named_sources.hpp"

#include <functional>
#include <numbers>

namespace filum::baselines::kipping2022 {

using std::numbers::pi;

using geom::Vec2;
using geom::Vec3;
using surface::Surface;

// A grid of n x m quads over the unit square, lifted; `round` joins its sides u = 0 and u = 1.
inline Surface grid(int n, int m, const std::function<Vec3(double, double)>& lift, bool round = false) {
    mesh::Mesh mesh;
    const int columns = round ? n : n + 1;
    for (int j = 0; j <= m; ++j)
        for (int i = 0; i < columns; ++i)
            mesh.vertices.push_back(lift(static_cast<double>(i) / n, static_cast<double>(j) / m));
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * columns + i % columns); };
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i)
            mesh.triangles.insert(mesh.triangles.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                         {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    Notes notes;
    return surface::connect(mesh, notes);
}

inline Surface rectangle(double w, double h) {
    const auto cells = [](double l) { return 2 * static_cast<int>(std::ceil(l / 2)); }; // a vertex in the middle
    return grid(cells(w), cells(h), [&](double u, double v) { return Vec3{w * u, h * v, 0}; });
}

// A square of 2 h around the origin with a round hole of radius r.
inline Surface holed(double h, double r) {
    return grid(
        96, 24,
        [&](double u, double v) {
            const double a = 2 * pi * u, c = std::cos(a), s = std::sin(a);
            const double out = h / std::max(std::abs(c), std::abs(s)), l = out + v * (r - out);
            return Vec3{l * c, l * s, 0};
        },
        true);
}

// Of a sphere around the origin, what is between two angles from its pole.
inline Surface zone(double r, double from, double to) {
    return grid(
        96, 32,
        [&](double u, double v) {
            const double a = 2 * pi * u, b = from + v * (to - from);
            return Vec3{r * std::sin(b) * std::cos(a), r * std::sin(b) * std::sin(a), r * std::cos(b)};
        },
        true);
}

inline surface::Sheet measured(Surface s, const char* source) {
    Notes notes;
    surface::Sheet sheet{std::move(s), {}, {}, {}};
    const auto sources = geodesic::named_sources(sheet.surface, source, notes);
    geodesic::measure(sheet, sources, {}, notes);
    return sheet;
}

inline double length(const surfpath::plan::Stroke& stroke) {
    double out = 0;
    for (const auto& piece : stroke.sections) out += surface::curve::length(piece.line);
    return out;
}
inline double length(const surfpath::plan::Plan& plan) {
    double out = 0;
    for (const auto& stroke : plan.strokes) out += length(stroke);
    return out;
}

inline double fact(const surfpath::plan::Plan& plan, const std::string& name) {
    for (const auto& f : plan.facts)
        if (f.name == name) return f.value;
    return std::nan("");
}

} // namespace filum::baselines::kipping2022
