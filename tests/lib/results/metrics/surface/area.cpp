// Areas that are known: lines, circles, cylinders, walls.
#include "metrics/surface/area.hpp"
#include "paths.hpp"

#include <gtest/gtest.h>

namespace filum::metrics::surface {
namespace {

using paths::measure;
using paths::number;
using paths::span;
using paths::Vec2;

using std::numbers::pi;
const std::string kPaper = "paper: share within d of points";

Surface plate(double a, double b) {
    return surfaces::sheet(a, b, static_cast<int>(2 * a), static_cast<int>(2 * b), 7).surface;
}

TEST(Area, ParallelLines) {
    const Surface s = plate(20, 20);
    // a bead beside the other: whole; every other one: half, where the paper says whole; two of five: 0.4
    const auto whole = measure(s, paths::parallel(0, 20, 0.5, 1, 20));
    EXPECT_NEAR(number(whole, "coverage"), 1, 1e-6);
    EXPECT_NEAR(number(whole, "fill ratio"), 1, 1e-6);
    EXPECT_NEAR(number(whole, "largest void beyond beads"), 0, 1e-6);
    const auto half = measure(s, paths::parallel(0, 20, 1, 2, 10));
    EXPECT_NEAR(number(half, "coverage"), 0.5, 5e-4);
    EXPECT_NEAR(number(half, kPaper), 1, 1e-2);
    EXPECT_NEAR(number(half, "largest void beyond beads"), 0.5, 1e-3);
    const auto wide = measure(s, paths::parallel(0, 20, 1.25, 2.5, 8));
    EXPECT_NEAR(number(wide, "coverage"), 0.4, 5e-4);
    EXPECT_GT(number(wide, kPaper), 0.8);
    const auto doubled = measure(s, paths::parallel(0, 20, 0.5, 0.5, 39));
    EXPECT_NEAR(number(doubled, "overlap"), 39 * 20 / 400.0 - 1, 1e-4);
}

TEST(Area, DoesNotDependOnTheTriangles) {
    const Surface coarse = surfaces::make({{0, 0, 0}, {20, 0, 0}, {20, 20, 0}, {0, 20, 0}}, {{0, 1, 2}, {0, 2, 3}});
    const auto lines = paths::parallel(1, 17, 1.7, 1.43, 12);
    EXPECT_NEAR(number(measure(coarse, lines), "coverage"), number(measure(plate(20, 20), lines), "coverage"), 2e-4);
}

TEST(Area, OfARing) {
    const double r = 5;
    const auto ring = paths::lifted(paths::arc({10, 10}, r, 0, 2 * pi, [] { return 0.05; }), [](Vec2 p) {
        return Vec3{p.x, p.y, 0};
    });
    const auto f = measure(plate(20, 20), {span(ring)});
    EXPECT_NEAR(number(f, "coverage"), 2 * pi * r / 400, 2e-4);
    // the corners are farther from the ring than its middle
    EXPECT_NEAR(number(f, "largest void beyond beads"), std::sqrt(200) - r - 0.5, 2e-3);
}

TEST(Area, WidthsDiffer) {
    const auto f = measure(plate(20, 20), {span({{0, 5, 0}, {20, 5, 0}}, 1), span({{0, 12, 0}, {20, 12, 0}}, 3)});
    EXPECT_NEAR(number(f, "coverage"), 4 * 20 / 400.0, 2e-4);
    const auto cross = measure(plate(20, 20), {span({{0, 10, 0}, {20, 10, 0}}, 1), span({{10, 0, 0}, {10, 20, 0}}, 3)});
    EXPECT_NEAR(number(cross, "coverage"), (20 + 60 - 3) / 400.0, 2e-4);
}

TEST(Area, OnACylinder) {
    const double r = 6;
    const auto bent = surfaces::sheet(12, 10, 48, 40, 2, [&](Vec2 p) {
        return Vec3{r * std::cos(p.x / r), r * std::sin(p.x / r), p.y};
    });
    std::vector<paths::Span> lines;
    for (int i = 0; i < 5; ++i)
        lines.push_back(span(paths::lifted(paths::arc({0, 0}, r, 0, 2, [] { return 0.05; }), [&](Vec2 p) {
            return Vec3{p.x, p.y, 1 + 2.0 * i};
        })));
    const auto f = measure(bent.surface, lines);
    EXPECT_NEAR(number(f, "coverage"), 0.5, 2e-3);
    EXPECT_LT(number(f, "max", "off the surface"), 0.01);
}

// Two skins 0.2 mm apart, joined along one side: a path on one covers nothing of the other but around that edge.
TEST(Area, DoesNotSeeThroughAWall) {
    const auto wall = surfaces::sheet(20.2, 10, 101, 40, 4, [](Vec2 p) {
        return p.x <= 10 ? Vec3{p.x, p.y, 0} : p.x <= 10.2 ? Vec3{10, p.y, p.x - 10} : Vec3{20.2 - p.x, p.y, 0.2};
    });
    const auto f = measure(wall.surface, {span({{2, 0, 0}, {2, 10, 0}}), span({{4, 0, 0}, {4, 10, 0}})});
    EXPECT_NEAR(number(f, "coverage"), 20 / (2 * 100.0 + 2), 2e-3);
    EXPECT_NEAR(number(f, "largest void beyond beads"), 6 + 0.2 + 10 - 0.5, 0.06);
}

TEST(Area, AlongRimsAndWithoutAPath) {
    const Surface two =
        surfaces::make({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {20, 0, 0}, {22, 0, 0}, {20, 2, 0}},
                       {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
    const auto f = measure(two, paths::parallel(0, 10, 1.5, 1, 8));
    EXPECT_NEAR(number(f, "parts of the surface without a path"), 2, 1e-9);
    EXPECT_NEAR(number(f, "coverage"), 80 / 102.0, 1e-3);
    EXPECT_NEAR(number(f, "largest void beyond beads"), 1, 2e-3);
    // within 1 mm of the rims of the square, 16 of 36 mm2 lie under beads; the triangle is nearer than 1 all over
    EXPECT_NEAR(number(f, "coverage within d of a rim"), 16 / 38.0, 2e-3);
}

TEST(Area, OfAPathThatHovers) {
    auto lines = paths::parallel(0, 20, 1, 2, 10);
    for (auto& l : lines)
        for (auto& p : l.points) p.z = 0.3;
    const auto f = measure(plate(20, 20), lines);
    EXPECT_NEAR(number(f, "coverage"), 0.5, 5e-4);
    EXPECT_NEAR(number(f, "max", "off the surface"), 0.3, 1e-9);
    EXPECT_NEAR(number(f, "p99", "off the surface"), 0.3, 1e-9);
}

TEST(Area, OfAPathThatLeavesTheSurface) {
    const auto f = measure(plate(20, 20),
                           {span({{0, 5, 0.3}, {20, 5, 0.3}}),
                            span({{0, 15, 0.3}, {5, 15, 0.3}, {5, 15, 2}, {15, 15, 2}, {15, 15, 0.3}, {20, 15, 0.3}})});
    EXPECT_NEAR(number(f, "path above the surface"), 10 + 2 * 1.2,
                0.01); // from half a bead above the 0.3 mm of the rest
    EXPECT_NEAR(number(f, "coverage"), (30 + pi / 4) / 400, 1e-3);
}

TEST(Area, OfAPathPastTheRim) {
    const auto f = measure(plate(10, 10), {span({{-5, 5, 0}, {15, 5, 0}}), span({{0, -0.3, 0}, {10, -0.3, 0}})});
    EXPECT_NEAR(number(f, "coverage"), 0.1, 2e-3); // except for the half discs of 0.05 mm past the rim
    EXPECT_NEAR(number(f, "path beside the surface"), 20, 0.15);
    EXPECT_NEAR(number(f, "path beside the surface, share"), 20.0 / 30, 0.005);
    EXPECT_NEAR(number(f, "max", "off the surface"), 5, 1e-9);
}

// Two plies of lines 2 mm apart, one across the other and above it: half each, nothing retraced; a third one is empty
// except for a line.
TEST(Area, PlyByPly) {
    auto spans = paths::parallel(0, 20, 1, 2, 10);
    const auto across = [](double x, double z, std::uint32_t layer) {
        auto s = span({{x, 0, z}, {x, 20, z}});
        s.layer = layer;
        return s;
    };
    for (int i = 0; i < 10; ++i) spans.push_back(across(1 + 2 * i, 0.2, 1));
    const auto two = measure(plate(20, 20), spans);
    EXPECT_EQ(number(two, "plies"), 2);
    EXPECT_NEAR(number(two, "surface"), 400, 1e-9);
    EXPECT_NEAR(number(two, "coverage"), 0.5, 5e-4);
    EXPECT_NEAR(number(two, "fill ratio"), 0.5, 1e-9);
    EXPECT_NEAR(number(two, "cuts per 1000 mm2"), 19 / 0.8, 1e-9);
    spans.push_back(across(7, 1.5, 4));
    const auto three = measure(plate(20, 20), spans);
    EXPECT_NEAR(number(three, "coverage of the worst ply"), 0.05, 1e-3);
    EXPECT_NEAR(number(three, "largest void beyond beads"), 12.5, 0.01);
    EXPECT_EQ(number(three, "retraced"), 0);
    EXPECT_TRUE(std::isnan(number(three, "path above the surface")));
}

// Rows and windows against a plain count of places: a path of chords over bumps, where fronts bend and meet.
TEST(Area, OnBumpsAgainstPlaces) {
    const auto bumps = surfaces::sheet(10, 10, 14, 14, 12, [](Vec2 p) {
        return Vec3{p.x, p.y, 0.8 * std::sin(1.3 * p.x) * std::sin(1.1 * p.y + p.x)};
    });
    const Surface& s = bumps.surface;
    const Ground ground(s, 1);
    std::vector<paths::Span> lines;
    for (int i = 0; i < 6; ++i) lines.push_back(span({{1, 1.5 * i + 0.7, 0.2}, {9, 1.3 * i + 1.4, -0.1}}));
    const PathField field = path_field(ground, shadow(paths::fibres(lines), ground, {0, 0.5, 0.1}, 1));
    const Area area = measure_area(ground, field, 1, 1);
    double covered = 0;
    const int n = 24;
    for (std::uint32_t t = 0; t < ground.finer.surface.triangles.size(); ++t) {
        const auto& [a, b, c] = ground.finer.surface.triangles[t];
        const auto& v = ground.finer.surface.vertices;
        const double part = norm(cross(v[b] - v[a], v[c] - v[a])) / 2 / (n * n);
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < 2 * (n - i) - 1; ++j) { // the middles of n * n like triangles
                const double y = (i + (j % 2 == 0 ? 1.0 : 2.0) / 3) / n, x = (j / 2 + (j % 2 == 0 ? 1.0 : 2.0) / 3) / n;
                const Vec3 p = v[a] + x * (v[b] - v[a]) + y * (v[c] - v[a]);
                covered += clearance(ground, field, t, p) <= 0 ? part : 0;
            }
    }
    EXPECT_NEAR(area.covered / area.surface, covered / area.surface, 1e-3);
    EXPECT_GT(area.covered / area.surface, 0.3);
}

TEST(Finer, IsTheSameSurface) {
    const auto bumpy = surfaces::bumpy_sphere(2, 0.1, 3);
    const filum::surface::FinerSurface f = finer(bumpy, 0.07);
    EXPECT_GT(f.surface.triangles.size(), 10 * bumpy.triangles.size());
    EXPECT_NEAR(filum::surface::area(f.surface), filum::surface::area(bumpy), 1e-12 * 1e4);
    EXPECT_TRUE(f.surface.rims.empty());
    for (std::uint32_t h = 0; h < f.surface.twin.size(); ++h)
        EXPECT_LE(distance(f.surface.vertices[f.surface.tail(h)], f.surface.vertices[f.surface.head(h)]), 0.07);
    const Surface open = plate(5, 5);
    const filum::surface::FinerSurface g = finer(open, 0.2);
    ASSERT_EQ(g.surface.rims.size(), 1);
    EXPECT_NEAR(filum::surface::rim_length(g.surface, g.surface.rims[0]), 20, 1e-9);
    EXPECT_EQ(g.surface.components, 1);
    EXPECT_EQ(finer(open, 1e-9, 500).surface.triangles.size(), open.triangles.size());
}

} // namespace
} // namespace filum::metrics::surface
