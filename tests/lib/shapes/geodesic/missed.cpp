// Where windows end or begin by rounding: at vertices from both sides, along sides.
#include "geodesic/exact.hpp"
#include "surface/trace.hpp"
#include "surfaces.hpp"

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
TEST(Exact, ReachesVerticesOnTheBordersOfWindows) {
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

TEST(Exact, RaysAlongSidesMakeNoWindowWithoutNumbers) {
    for (unsigned seed = 0; seed < 60; ++seed) { // plane grids, turned: their sides lie in lines, up to rounding
        const double angle = 0.1 * seed, c = std::cos(angle), d = std::sin(angle);
        std::vector<Vec3> v;
        std::vector<mesh::Triangle> t;
        for (int i = 0; i < 9; ++i)
            for (int j = 0; j < 9; ++j) v.push_back({c * i - d * j, 0.6 * (d * i + c * j), 0.8 * (d * i + c * j)});
        for (std::uint32_t i = 0; i < 8; ++i)
            for (std::uint32_t j = 0; j < 8; ++j) {
                const std::uint32_t a = 9 * i + j;
                t.push_back({a, a + 9, a + 10});
                t.push_back({a, a + 10, a + 1});
            }
        v[40].z += 0.3; // so that paths bend
        const Surface s = surfaces::make(v, t);
        for (std::uint32_t from = 0; from < s.vertices.size(); from += 7) {
            const ExactField f = exact(s, {{from}, {}});
            for (const std::uint32_t list : f.first)
                for (std::uint32_t w = list; w != surface::kNone; w = f.windows[w].next)
                    EXPECT_TRUE(f.windows[w].b0 < f.windows[w].b1);
        }
    }
}

} // namespace
} // namespace filum::geodesic
