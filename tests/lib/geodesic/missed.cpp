// Vertices at which windows end from both sides.
#include "geodesic/exact.hpp"
#include "surface/trace.hpp"

#include <gtest/gtest.h>

#include <iomanip>
#include <numbers>
#include <sstream>
#include <string>

namespace filum::geodesic {
namespace {

double rounded(double v, int digits) {
    return std::stod((std::ostringstream() << std::setprecision(digits) << v).str());
}

// A sector of a ring whose vertices lie on rays from its centre: windows end at vertices again and again, and by
// rounding before them on both sides.
TEST(exact, reaches_vertices_on_the_borders_of_windows) {
    const std::uint32_t nu = 120, nv = 80;
    mesh::Mesh m;
    for (std::uint32_t j = 0; j <= nv; ++j)
        for (std::uint32_t i = 0; i <= nu; ++i) {
            const double a = std::numbers::pi / 2 * (1 - static_cast<double>(i) / nu), r = 20 + 40.0 * j / nv;
            m.vertices.push_back({rounded(r * std::cos(a), 9), rounded(r * std::sin(a), 9), 0});
        }
    const auto at = [&](std::uint32_t i, std::uint32_t j) { return j * (nu + 1) + i; };
    for (std::uint32_t j = 0; j < nv; ++j)
        for (std::uint32_t i = 0; i < nu; ++i)
            m.triangles.insert(m.triangles.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                   {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    Notes notes;
    const Surface s = surface::connect(m, notes);
    std::vector<Vec3> arc;
    for (std::uint32_t i = 0; i <= nu; ++i) {
        const double a = std::numbers::pi / 2 * (1 - static_cast<double>(i) / nu);
        arc.push_back({rounded(20 * std::cos(a), 12), rounded(20 * std::sin(a), 12), 0});
    }
    Sources sources;
    sources.segments = surface::trace(s, arc).segments;
    const ExactField field = exact(s, sources);
    for (std::size_t v = 0; v < s.vertices.size(); ++v) EXPECT_NEAR(field.distance[v], norm(s.vertices[v]) - 20, 0.001);
}

} // namespace
} // namespace filum::geodesic
