#include "geom/principal_axis.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <vector>

namespace filum::geom {
namespace {

TEST(PrincipalAxis, IsThatOfTheSpread) {
    std::mt19937 random(3);
    for (int round = 0; round < 50; ++round) {
        const double angle = (round - 25) * std::numbers::pi / 51; // less than a quarter turn
        const Vec2 along{std::cos(angle), std::sin(angle)}, centre{7.0 * round, -3};
        std::vector<Vec2> points;
        for (int k = 0; k < 200; ++k) { // a cloud and its mirror image, so that the axis is exact
            const double s = 5.0 * (random() / 4294967296.0), t = 1.0 * (random() / 4294967296.0);
            for (const double a : {s, -s})
                for (const double b : {t, -t}) points.push_back(centre + a * along + b * left_of(along));
        }
        const Axis axis = principal_axis(points);
        EXPECT_NEAR(distance(axis.mean, centre), 0, 1e-9);
        EXPECT_NEAR(dot(axis.direction, along), 1, 1e-9);
    }
}

TEST(PrincipalAxis, UprightPointsUp) {
    const Axis axis = principal_axis(std::vector<Vec2>{{1, 5}, {1, -9}, {1, 0}});
    EXPECT_NEAR(axis.direction.y, 1, 1e-9);
}

TEST(PrincipalAxis, LeavesAtTheFarSide) {
    const std::vector<Vec2> box{{0, 0}, {10, 0}, {10, 4}, {0, 4}};
    const auto at = leaves(principal_axis(box), box);
    ASSERT_TRUE(at.has_value());
    EXPECT_NEAR(distance(*at, Vec2{10, 2}), 0, 1e-9);
    EXPECT_FALSE(leaves({{0, 20}, {1, 0}}, box).has_value());
}

} // namespace
} // namespace filum::geom
