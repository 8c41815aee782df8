#include "collision/shape.hpp"

#include "collision/gjk.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace {

using namespace filum;
using collision::HeadPiece;
using collision::Shape;
using geom::Vec3;

constexpr double kInf = std::numeric_limits<double>::infinity();
const double kSin60 = std::sin(std::numbers::pi / 3);

double to_point(const Shape& s, const Vec3& p, bool round = false) {
    const std::array<Vec3, 1> corner{p};
    return s.nearest(corner, round, kInf).distance;
}

TEST(Shape, KnownDistancesOfPoints) {
    const Shape s(machine::Head{}); // flat 0.2, 60 degrees, 8 high, 40 x 40
    EXPECT_DOUBLE_EQ(to_point(s, {0, 0, -3}), 3);
    EXPECT_NEAR(to_point(s, {3.2, 0, -4}), 5, 1e-7);
    EXPECT_NEAR(to_point(s, {0, 1.2, 0}), kSin60, 1e-7); // from the edge of the flat the side rises by 60 degrees
    EXPECT_NEAR(to_point(s, {25, 0, 9}), 5, 1e-7);
    EXPECT_NEAR(to_point(s, {23, 24, 50}), 5, 1e-7); // the corner of the box
    EXPECT_NEAR(to_point(s, {0, 30, 50}, true), 30 - std::hypot(20, 20), 1e-7);
    EXPECT_EQ(to_point(s, {0, 0, 4}), 0);
    EXPECT_EQ(to_point(s, {19, 19, 8.5}), 0);
    EXPECT_EQ(to_point(s, {19, 19, 8.5}, true), 0);
}

TEST(Shape, NamesThePiece) {
    machine::Head head;
    head.gantry_height = 30;
    const Shape s(head);
    const auto piece = [&](const Vec3& p) { return s.nearest(std::array<Vec3, 1>{p}, false, kInf).piece; };
    EXPECT_EQ(piece({1, 0, 1}), HeadPiece::nozzle);
    EXPECT_EQ(piece({15, 0, 7}), HeadPiece::carriage);
    EXPECT_EQ(piece({500, 0, 29}), HeadPiece::gantry);
    EXPECT_NEAR(to_point(s, {500, 0, 29}), 1, 1e-9);
    EXPECT_EQ(to_point(s, {500, 0, 31}), 0);
}

TEST(Shape, AWideNozzleGoesOnAboveANarrowCarriage) {
    machine::Head head;
    head.cone_angle = std::numbers::pi / 2;
    head.carriage_x = head.carriage_y = 2;
    EXPECT_NEAR(to_point(Shape(head), {10, 0, 40}), 10 - 8.2, 1e-7);
}

TEST(Shape, DegenerateHeads) {
    machine::Head needle{0, 0, 0, 0, 0, kInf, false};
    EXPECT_NEAR(to_point(Shape(needle), {3, 4, 10}), 5, 1e-7);
    EXPECT_NEAR(to_point(Shape(needle), {3, 0, -4}), 5, 1e-7);
    EXPECT_TRUE(Shape(machine::Head{.none = true}).none());
}

// Against the least over many points of the triangle, each by the formula for cone and box.
TEST(Shape, TrianglesAgreeWithTheirPoints) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> xy(-40, 40), z(-6, 14);
    const Shape s(machine::Head{});
    constexpr int n = 60;
    for (int trial = 0; trial < 60; ++trial) {
        std::array<Vec3, 3> t;
        for (Vec3& p : t) p = {xy(random), xy(random), z(random)};
        double least = kInf, bound = kInf;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; i + j <= n; ++j) {
                const Vec3 p = (1.0 / n) * (i * t[0] + j * t[1] + (n - i - j) * t[2]);
                least = std::min(least, to_point(s, p));
                const double b = s.at_least(std::hypot(p.x, p.y), p.z);
                EXPECT_LE(b, to_point(s, p, true) + 1e-7);
                bound = std::min(bound, b);
            }
        const double got = s.nearest(t, false, kInf).distance;
        EXPECT_LE(got, least + 1e-7);
        EXPECT_GE(got, least - 1.5); // points are so far apart
        EXPECT_GE(got, bound - 1.5);
        EXPECT_LE(s.nearest(t, true, kInf).distance, got + 1e-7); // the column holds the box
        EXPECT_EQ(s.nearest(t, false, got / 2).distance, got / 2);
    }
}

TEST(Gjk, DegeneratePolygons) {
    const Shape s(machine::Head{});
    const std::array<Vec3, 3> line{Vec3{5, -1, -1}, {5, 1, -1}, {5, 3, -1}},
        dot{Vec3{5, 0, -1}, {5, 0, -1}, {5, 0, -1}};
    const double want = to_point(s, {5, 0, -1});
    EXPECT_NEAR(s.nearest(line, false, kInf).distance, want, 1e-7);
    EXPECT_NEAR(s.nearest(dot, false, kInf).distance, want, 1e-7);
}

} // namespace
