// Isolines lie where the distance has their level, and hang together.
#include "geodesic/isolines.hpp"
#include "../surface/grid.hpp"
#include "base/error.hpp"
#include "geodesic/certificate.hpp"
#include "geodesic/measure.hpp"
#include "geodesic/named_sources.hpp"
#include "geodesic/query.hpp"
#include "surface/finer.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>

namespace filum::geodesic {
namespace {

using surface::kNone;
using surfaces::Vec2;

// Its points lie in the triangles that are named.
void expect_on_surface(const Surface& s, const Isoline& line) {
    ASSERT_EQ(line.triangles.size() + (line.closed ? 0 : 1), line.points.size());
    for (std::size_t i = 0; i < line.triangles.size(); ++i) {
        const auto& [a, b, c] = s.triangles[line.triangles[i]];
        for (const Vec3& p : {line.points[i], line.points[(i + 1) % line.points.size()]}) {
            EXPECT_NEAR(dot(p - s.vertices[a], surface::normal(s, line.triangles[i])), 0, 1e-9);
            for (const auto& [u, v] : {std::pair{a, b}, {b, c}, {c, a}})
                EXPECT_GT(
                    dot(cross(s.vertices[v] - s.vertices[u], p - s.vertices[u]), surface::normal(s, line.triangles[i])),
                    -1e-9);
        }
    }
}

TEST(Isolines, AroundAPointInThePlaneAreCircles) {
    const auto s = surfaces::sheet(20, 20, 20, 20, 1);
    const Vec3 p{10.1, 9.7, 0};
    const auto field = exact(s.surface, {{}, {surface::nearest(s.surface, p)}});
    const double levels[] = {2, 4, 6, 8, 9.5, 11, 13};
    const auto lines = isolines(s.surface, field, levels);
    std::vector<int> closed(14, 0), open(14, 0);
    for (const Isoline& line : lines) {
        expect_on_surface(s.surface, line);
        double turned = 0; // the nearer side to the left: counter-clockwise around the point
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            EXPECT_NEAR(distance(line.points[i], p), line.level, 1e-5);
            if (i + 1 < line.points.size()) turned += cross(line.points[i] - p, line.points[i + 1] - p).z;
        }
        EXPECT_GT(turned, 0);
        ++(line.closed ? closed : open)[static_cast<std::size_t>(line.level)];
    }
    EXPECT_EQ(closed, (std::vector<int>{0, 0, 1, 0, 1, 0, 1, 0, 1, 1, 0, 0, 0, 0}));
    EXPECT_EQ(open, (std::vector<int>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 4, 0, 4}));
}

TEST(Isolines, OfABumpySurfaceAreClosedAndHaveTheirLevel) {
    for (unsigned seed = 0; seed < 6; ++seed) {
        const Surface s = surfaces::bumpy_sphere(3, 0.15, seed);
        const auto field = exact(s, {{seed, 40 + seed}, {}});
        std::vector<double> levels;
        for (int i = 1; i < 40; ++i) levels.push_back(0.08 * i);
        const auto lines = isolines(s, field, levels);
        EXPECT_GT(lines.size(), 20U);
        for (const Isoline& line : lines) {
            EXPECT_TRUE(line.closed) << seed << " at " << line.level;
            expect_on_surface(s, line);
            for (std::size_t i = 0; i < line.triangles.size(); ++i)
                EXPECT_NEAR(distance_at(s, field, line.triangles[i], line.points[i]), line.level, 1.01e-3);
        }
    }
}

TEST(Isolines, EdgesMayBeCrossedTwice) {
    // two sources, one at each end of a strip of two long triangles: between them the distance rises and falls
    const Surface s = surfaces::make({{0, 0, 0}, {10, 0, 0}, {10, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
    const auto field = exact(s, {{0, 1, 2, 3}, {}});
    std::vector<double> at;
    level_crossings(s, field, 0, 3, at);
    ASSERT_EQ(at.size(), 2U);
    EXPECT_NEAR(at[0], 3, 1e-12);
    EXPECT_NEAR(at[1], 7, 1e-12);
    level_crossings(s, field, 0, 5.1, at);
    EXPECT_TRUE(at.empty());
    const double level[] = {3};
    const auto lines = isolines(s, field, level);
    ASSERT_EQ(lines.size(), 2U); // across the strip, near either end
    for (const auto& line : lines) EXPECT_FALSE(line.closed);
    EXPECT_NEAR(std::abs(lines[0].points.front().x - lines[0].points.back().x), 0, 1e-9);
}

TEST(Isolines, AreRoundBetweenEdges) {
    const Surface s = surfaces::make({{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, {{0, 1, 2}, {0, 2, 3}});
    const double level[] = {6};
    const auto lines = isolines(s, exact(s, {{0}, {}}), level);
    ASSERT_EQ(lines.size(), 1U);
    double length = 0;
    for (std::size_t i = 1; i < lines[0].points.size(); ++i) {
        length += distance(lines[0].points[i - 1], lines[0].points[i]);
        EXPECT_NEAR(norm(lines[0].points[i]), 6, 1e-5);
        EXPECT_NEAR(norm(0.5 * (lines[0].points[i - 1] + lines[0].points[i])), 6, 1e-3);
    }
    EXPECT_NEAR(length, 3 * std::numbers::pi, 2e-3);
}

// The middle of the left rim's triangle is 0.5 mm from it, less a rounding: what lies about it is farther.
TEST(Isolines, ThatPassAVertexByARoundingAreClosed) {
    Notes notes;
    const auto coarse = surface::connect(surface::flat_grid(8, 1.8, 8, 1), notes);
    const Surface s = surface::finer(coarse, 1, 10'000).surface;
    const double level[] = {0.5};
    const auto lines = isolines(s, exact(s, surface::rim_sources(s)), level);
    ASSERT_EQ(lines.size(), 1U);
    EXPECT_TRUE(lines[0].closed);
}

TEST(Isolines, OfLinearValuesCutEdgesInProportion) {
    const auto s = surfaces::sheet(10, 10, 10, 10, 3);
    std::vector<double> height;
    for (const Vec2 p : s.flat) height.push_back(p.x + 0.3 * p.y);
    const double levels[] = {1, 6.5, 12};
    const auto lines = isolines(s.surface, height, levels);
    ASSERT_EQ(lines.size(), 3U);
    for (const auto& line : lines) {
        EXPECT_FALSE(line.closed);
        for (const Vec3& p : line.points) EXPECT_NEAR(p.x + 0.3 * p.y, line.level, 1e-9);
    }
}

TEST(Isolines, DoNotCrossIntoUnreachedComponents) {
    const Surface s =
        surfaces::make({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {9, 0, 0}, {9, 4, 0}, {5, 0, 0}}, {{0, 1, 2}, {3, 4, 5}});
    const double levels[] = {1, 2};
    EXPECT_EQ(isolines(s, exact(s, {{0}, {}}), levels).size(), 2U);
}

TEST(Choose, NamesSources) {
    const auto s = surfaces::sheet(
        12, 12, 12, 12, 5,
        [](Vec2 p) {
            return Vec3{p.x, p.y, 0};
        },
        [](int i, int j) { return i >= 4 && i < 8 && j >= 4 && j < 8; });
    Notes notes;
    const auto count = [&](const char* words) {
        const Sources got = named_sources(s.surface, words, notes);
        return std::pair{got.vertices.size(), got.segments.size()};
    };
    EXPECT_EQ(count(""), (std::pair<std::size_t, std::size_t>{0, 0}));
    EXPECT_EQ(count("vertex:3 vertex:5"), (std::pair<std::size_t, std::size_t>{2, 0}));
    EXPECT_EQ(count("boundary"), (std::pair<std::size_t, std::size_t>{0, 64}));
    EXPECT_EQ(count("boundary:all;vertex:1"), (std::pair<std::size_t, std::size_t>{1, 64}));
    EXPECT_EQ(count("boundary:outer"), (std::pair<std::size_t, std::size_t>{0, 48}));
    EXPECT_EQ(count("boundary:1"), (std::pair<std::size_t, std::size_t>{0, 16}));
    EXPECT_GT(count("plane:1,0,0,2.5").second, 12U);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(count("point:1,1,0 point:6,6,0"), (std::pair<std::size_t, std::size_t>{0, 2}));
    ASSERT_EQ(notes.size(), 1U); // the second lies in the hole
    EXPECT_GT(notes[0].amount, 1);
    for (const char* bad : {"vertex", "vertex:-1", "vertex:1.5", "vertex:1000", "vertex:x", "edge:3", "boundary:2",
                            "boundary:inner", "plane:0,0,0,1", "plane:1,0,0", "plane:0,0,1,5", "point:1,2",
                            "point:1,2,nan", "point:1,2,inf", "plane:1,0,0,2.5,"}) {
        try {
            named_sources(s.surface, bad, notes);
            ADD_FAILURE() << bad;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::usage) << bad;
        }
    }
    EXPECT_THROW(named_sources(surfaces::cube(1), "boundary", notes), Error);
}

TEST(Certificate, MeasuresSlopes) {
    const auto s = surfaces::sheet(10, 10, 10, 10, 3);
    std::vector<double> d;
    for (const Vec2 p : s.flat) d.push_back(0.6 * p.x + 0.8 * p.y);
    const SlopeError none = slope_error(s.surface, d);
    EXPECT_NEAR(none.p99, 0, 1e-12);
    EXPECT_NEAR(none.area, 100, 1e-9);
    EXPECT_NEAR(none.share[0], 1, 1e-12);
    EXPECT_LE(excess(s.surface, d), 1e-12);
    for (double& v : d) v *= 1.05;
    const SlopeError some = slope_error(s.surface, d);
    EXPECT_NEAR(some.mean, 0.05, 1e-12);
    EXPECT_NEAR(some.p99, 0.05, 1e-12);
    EXPECT_NEAR(some.share[4], 1, 1e-12); // 0.03 to 0.1
    EXPECT_GT(excess(s.surface, d), 0.01);
    d[0] = std::numeric_limits<double>::infinity();
    EXPECT_LT(slope_error(s.surface, d).area, 100);
}

TEST(Measure, DrawsLevelsAndMultiplesOfTheSpacing) {
    surface::Sheet sheet{surfaces::sheet(10, 4, 10, 4, 3).surface, {}, {}};
    Notes notes;
    const auto sources = named_sources(sheet.surface, "plane:1,0,0,0", notes);
    measure(sheet, sources, {.levels = {0.7}, .spacing = 2, .first = 1}, notes);
    std::vector<double> levels;
    for (const auto& line : sheet.isolines) levels.push_back(line.level);
    EXPECT_EQ(levels, (std::vector<double>{0.7, 1, 3, 5, 7, 9}));
    ASSERT_EQ(sheet.fields.size(), 1U);
    EXPECT_EQ(sheet.fields[0].name, "distance");
    EXPECT_THROW(measure(sheet, sources, {.levels = {-1}, .spacing = 0, .first = 0}, notes), Error);
    EXPECT_THROW(measure(sheet, sources, {.levels = {}, .spacing = 1e-9, .first = 0}, notes), Error);
}

} // namespace
} // namespace filum::geodesic
