#include "geodesic/sides.hpp"

#include "base/error.hpp"
#include "geodesic/measure.hpp"
#include "geodesic/named_sources.hpp"
#include "surface/trace.hpp"
#include "surfaces.hpp"

#include <gtest/gtest.h>

namespace filum::geodesic {
namespace {

using geom::Vec2;
using surfaces::sheet;

Sources from(const Surface& s, const char* words) {
    Notes notes;
    return named_sources(s, words, notes);
}

TEST(Sides, OfAPlaneAreItsNormals) {
    const auto plate = sheet(20, 10, 31, 17, 1, [](Vec2 p) { return Vec3{p.x, p.y, std::sin(p.x / 3)}; });
    for (const double way : {1.0, -1.0}) {
        const auto words = way > 0 ? "plane:1,0.3,0,8" : "plane:-1,-0.3,0,-8";
        const Sides found = sides(plate.surface, from(plate.surface, words));
        EXPECT_NO_THROW(check(found, "it"));
        EXPECT_EQ(found.mixed, 0);
        for (std::size_t v = 0; v < found.of.size(); ++v) {
            const Vec2 p = plate.flat[v];
            EXPECT_EQ(found.of[v], way * (p.x + 0.3 * p.y - 8) > 0 ? 1 : -1);
        }
    }
}

TEST(Sides, OfTwoCutsOfOnePlaneThroughATube) { // the plane meets the tube in two circles
    const auto torus = sheet(2 * std::numbers::pi, 2 * std::numbers::pi * 0.95, 48, 40, 2, [](Vec2 p) {
        const double r = 10 + 3 * std::cos(p.x);
        return Vec3{r * std::cos(p.y), r * std::sin(p.y), 3 * std::sin(p.x)};
    });
    const Sides found = sides(torus.surface, from(torus.surface, "plane:0,1,0,2"));
    for (std::size_t v = 0; v < found.of.size(); ++v) EXPECT_EQ(found.of[v], torus.surface.vertices[v].y > 2 ? 1 : -1);
}

TEST(Sides, OfAPolylineAreLeftAndRight) {
    const auto plate = sheet(20, 10, 21, 11, 3);
    const std::vector<Vec3> bent{{0, 3, 0}, {7, 3.2, 0}, {8, 7, 0}, {12.3, 7.1, 0}, {12.4, 2, 0}, {20, 2.2, 0}};
    Sources s;
    s.segments = surface::trace(plate.surface, bent).segments;
    const Sides found = sides(plate.surface, s);
    EXPECT_NO_THROW(check(found, "it"));
    for (std::size_t v = 0; v < found.of.size(); ++v) {
        const Vec2 p = plate.flat[v];
        const double y = p.x < 7       ? 3 + 0.2 * p.x / 7
                         : p.x < 8     ? 3.2 + 3.8 * (p.x - 7)
                         : p.x < 12.35 ? 7 + 0.1 * (p.x - 8) / 4.3
                                       : 2 + 0.2 * (p.x - 12.4) / 7.6;
        if (std::abs(p.y - y) < 0.3 || std::abs(p.x - 12.35) < 0.2) continue; // next to it
        EXPECT_EQ(found.of[v], p.y > y ? 1 : -1) << p.x;
    }
}

TEST(Sides, ALineThatEndsWithinDoesNotSeparate) {
    const auto plate = sheet(20, 10, 21, 11, 3);
    Sources s;
    s.segments = surface::trace(plate.surface, std::vector<Vec3>{{5.1, 0, 0}, {5.2, 7, 0}}).segments;
    const Sides found = sides(plate.surface, s);
    EXPECT_GT(found.mixed, 0.5 * found.length);
    EXPECT_THROW(check(found, "it"), Error);
}

TEST(Sides, PointsHaveNone) {
    const auto plate = sheet(20, 10, 21, 11, 3);
    EXPECT_THROW(check(sides(plate.surface, from(plate.surface, "vertex:5 point:3,3,0")), "it"), Error);
}

TEST(Sides, OfARimAreAllWithin) {
    const auto ring = sheet(
        9, 9, 9, 9, 4,
        [](Vec2 p) {
            return Vec3{p.x, p.y, 0};
        },
        [](int i, int j) { return i > 2 && i < 6 && j > 2 && j < 6; });
    const Sides found = sides(ring.surface, from(ring.surface, "boundary"));
    EXPECT_NO_THROW(check(found, "it"));
    for (std::size_t v = 0; v < found.of.size(); ++v) EXPECT_EQ(found.of[v], ring.surface.on_rim(v) ? 0 : 1);
}

TEST(Sides, OnAnotherComponentThereAreNone) {
    auto two = sheet(
        4, 4, 4, 4, 5,
        [](Vec2 p) {
            return Vec3{p.x < 2.5 ? p.x : p.x + 10, p.y, 0};
        },
        [](int i, int) { return i == 2; });
    const Sides found = sides(two.surface, from(two.surface, "plane:0,1,0,1.7"));
    EXPECT_EQ(two.surface.components, 2U);
    const Sides left = sides(two.surface, from(two.surface, "plane:1,0,0,1.2"));
    for (std::size_t v = 0; v < left.of.size(); ++v) {
        const double x = two.surface.vertices[v].x;
        EXPECT_EQ(left.of[v], x > 5 ? 0 : x > 1.2 ? 1 : -1);
        EXPECT_NE(found.of[v], 0);
    }
}

TEST(Sides, SignedDistancesAndLevels) {
    Notes notes;
    surface::Sheet plate;
    const auto flat = sheet(20, 10, 24, 13, 6);
    plate.surface = flat.surface;
    Options o;
    o.spacing = 1;
    o.first = 0.5;
    o.with_sides = true;
    plate.fields.push_back({"distance", std::vector<double>(flat.flat.size(), 7), 1}); // of before
    measure(plate, from(plate.surface, "plane:1,0,0,8.2"), o, notes);
    ASSERT_EQ(plate.fields.size(), 1U);
    for (std::size_t v = 0; v < flat.flat.size(); ++v)
        EXPECT_NEAR(plate.fields[0].values[v], flat.flat[v].x - 8.2, 1e-9);
    ASSERT_EQ(plate.isolines.size(), 20U); // -7.5 ... 11.5
    double level = -7.5;
    for (const auto& line : plate.isolines) {
        EXPECT_DOUBLE_EQ(line.level, level++);
        for (const Vec3& p : line.points) EXPECT_NEAR(p.x - 8.2, line.level, 1e-9);
        EXPECT_LT(line.points.front().y, line.points.back().y); // what is less lies to the left
    }
}

TEST(Sides, ClosedSignedIsolinesKeepTheirTriangles) {
    Notes notes;
    surface::Sheet plate;
    const auto flat = sheet(20, 20, 21, 21, 7);
    plate.surface = flat.surface;
    Sources s; // a square, clockwise: its inside is negative
    const std::vector<Vec3> square{{4, 4, 0}, {4, 16, 0}, {16, 16, 0}, {16, 4, 0}, {4, 4, 0}};
    s.segments = surface::trace(plate.surface, square).segments;
    Options o;
    o.levels = {2};
    o.with_sides = true;
    measure(plate, s, o, notes);
    ASSERT_EQ(plate.isolines.size(), 2U);
    const auto& inner = plate.isolines[0];
    EXPECT_EQ(inner.level, -2);
    ASSERT_TRUE(inner.closed);
    double area = 0;
    for (std::size_t i = 0; i < inner.points.size(); ++i) {
        const Vec3 p = inner.points[i], q = inner.points[(i + 1) % inner.points.size()];
        area += (p.x * q.y - p.y * q.x) / 2;
        const Vec3 m = 0.5 * (p + q);
        EXPECT_LT(distance(surface::nearest_in(plate.surface, inner.triangles[i], m), m), 1e-9);
    }
    EXPECT_NEAR(area, 64, 0.05); // counter-clockwise: what is less, farther in, lies to its left
}

} // namespace
} // namespace filum::geodesic
