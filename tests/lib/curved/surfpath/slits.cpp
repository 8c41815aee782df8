// Slits of surfaces without a rim, and the rings beside them.
#include "surfpath/slits.hpp"

#include "surfpath/fronts/source_lines.hpp"
#include "surfpath/seed_side.hpp"
#include "surfpath/surfpath.hpp"

#include "../../trials.hpp"
#include "plans.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace filum::surfpath {

using namespace fronts;
namespace {

using std::numbers::pi;

// A grid of n x m cells whose sides meet, `at` from angles to places.
mesh::Mesh round_both(std::uint32_t n, std::uint32_t m, const std::function<Vec3(double, double)>& at) {
    mesh::Mesh out;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < m; ++j) out.vertices.push_back(at(2 * pi * i / n, 2 * pi * j / m));
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < m; ++j) {
            const std::uint32_t a = m * i + j, b = m * ((i + 1) % n) + j;
            const std::uint32_t c = m * ((i + 1) % n) + (j + 1) % m, d = m * i + (j + 1) % m;
            out.triangles.insert(out.triangles.end(), {{a, b, c}, {a, c, d}});
        }
    return out;
}

mesh::Mesh torus(double large, double small) {
    return round_both(72, 24, [=](double u, double v) {
        const double r = large + small * std::cos(v);
        return Vec3{r * std::cos(u), r * std::sin(u), small * std::sin(v)};
    });
}

mesh::Mesh tetrahedron(double size) {
    mesh::Mesh out;
    out.vertices = {{0, 0, 0}, {size, 0, 0}, {0, size, 0}, {0, 0, size}};
    out.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
    return out;
}

// Sides of six squares, drawn out to a ball.
mesh::Mesh ball(double radius) {
    const std::uint32_t n = 16;
    mesh::Mesh out;
    const auto add = [&](const Vec3& x, const Vec3& y, const Vec3& z) {
        const auto first = static_cast<std::uint32_t>(out.vertices.size());
        for (std::uint32_t i = 0; i <= n; ++i)
            for (std::uint32_t j = 0; j <= n; ++j) {
                const Vec3 p = std::tan(pi / 4 * (2.0 * i / n - 1)) * x + std::tan(pi / 4 * (2.0 * j / n - 1)) * y + z;
                out.vertices.push_back(radius / norm(p) * p);
            }
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; j < n; ++j) {
                const std::uint32_t a = first + (n + 1) * i + j, b = a + n + 1;
                out.triangles.insert(out.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
            }
    };
    const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    for (const double side : {1.0, -1.0}) {
        add(side * x, y, side * z);
        add(side * y, z, side * x);
        add(side * z, x, side * y);
    }
    // Corners of neighbours in one place become one.
    std::vector<std::uint32_t> same(out.vertices.size());
    for (std::uint32_t v = 0; v < same.size(); ++v)
        for (same[v] = 0; distance(out.vertices[same[v]], out.vertices[v]) > 1e-9;) ++same[v];
    for (auto& t : out.triangles)
        for (auto& v : t) v = same[v];
    return out;
}

surface::Sheet closed_sheet(mesh::Mesh mesh) {
    Notes notes;
    return {surface::connect(std::move(mesh), notes), {}, {}};
}

double opened(const Notes& notes) {
    double out = 0;
    for (const Note& n : notes) out += n.code == NoteCode::surface_opened ? n.amount : 0;
    return out;
}

TEST(Slits, OfABallLeadHalfRoundIt) {
    Notes notes;
    const auto lines = source_lines(slits(closed_sheet(ball(10)), notes));
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_FALSE(lines[0].closed);
    EXPECT_NEAR(surface::curve::length(lines[0]), 10 * pi, 1);
    EXPECT_NEAR(opened(notes), surface::curve::length(lines[0]), 1e-6);
}

TEST(Slits, OfATorusGoRoundItTheShortWayAndDoNotDivideIt) {
    for (const auto& [large, small] : {std::pair{20.0, 5.0}, std::pair{12.0, 9.0}}) {
        Notes notes;
        const auto sheet = closed_sheet(torus(large, small));
        const auto slit = slits(sheet, notes);
        const auto lines = source_lines(slit);
        ASSERT_EQ(lines.size(), 1U);
        EXPECT_TRUE(lines[0].closed);
        EXPECT_NEAR(surface::curve::length(lines[0]), 2 * pi * std::min(small, large - small),
                    0.05 * 2 * pi * std::min(small, large - small));
        EXPECT_EQ(seed_sides(sheet.surface, slit).count, 1U);
    }
}

// Only a component without rim and source needs one.
TEST(Slits, AreOnlyWhereNothingElseSaysWhereLinesBegin) {
    auto mesh = torus(20, 5);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3 p : {Vec3{100, 0, 0}, Vec3{110, 0, 0}, Vec3{100, 10, 0}}) mesh.vertices.push_back(p);
    mesh.triangles.push_back({first, first + 1, first + 2});
    auto sheet = closed_sheet(std::move(mesh));
    Notes notes;
    for (const auto& g : slits(sheet, notes).segments) EXPECT_EQ(sheet.surface.component[g.triangle], 0U);
    EXPECT_EQ(notes.size(), 1U);
    sheet.sources.vertices = {0};
    EXPECT_TRUE(slits(sheet, notes).empty());
    EXPECT_EQ(notes.size(), 1U);
}

TEST(Opened, ClosedSurfacesOfAllKindsAreOneStrokeOfRings) {
    struct Case {
        mesh::Mesh mesh;
        Algorithm algorithm;
        double least; // share that is covered: whole rings leave corners bare
    };
    std::vector<Case> cases{{tetrahedron(15), Algorithm::hybrid, 0.91},
                            {tetrahedron(15), Algorithm::geo_contour, 0.89}};
    if (!kSanitized) {
        cases.push_back({ball(8), Algorithm::hybrid, 0.95});
        cases.push_back({ball(8), Algorithm::geo_fiso, 0.9});
        cases.push_back({torus(12, 5), Algorithm::hybrid, 0.95});
    }
    for (const Case& c : cases) {
        const auto sheet = closed_sheet(c.mesh);
        const Plan p = plan_paths(sheet, {.algorithm = c.algorithm});
        EXPECT_EQ(p.strokes.size(), 1U) << name(c.algorithm);
        EXPECT_GT(covered(sheet.surface, p), c.least) << name(c.algorithm);
        EXPECT_GT(opened(p.notes), 10) << name(c.algorithm);
    }
}

} // namespace
} // namespace filum::surfpath
