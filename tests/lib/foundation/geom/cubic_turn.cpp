#include "geom/cubic_turn.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace filum::geom {
namespace {

TEST(CubicTurn, FollowsTheCircleOfItsEndsAndTangents) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (int k = 0; k < 200; ++k) {
        const double r = 0.1 + 5 * share(random), begin = 2 * std::numbers::pi * share(random);
        const double sweep = std::numbers::pi * (0.01 + 0.99 * share(random)), sign = k % 2 == 0 ? 1 : -1;
        const Vec2 centre{10 * share(random), 10 * share(random)};
        const auto out = [&](double a) { return Vec2{std::cos(a), std::sin(a)}; };
        const auto along = [&](double a) { return sign * Vec2{-std::sin(a), std::cos(a)}; };
        const double end = begin + sign * sweep, step = r * (0.01 + share(random));
        const auto line = cubic_turn(centre + r * out(begin), along(begin), centre + r * out(end), along(end), step);
        ASSERT_GE(line.size(), 5U);
        EXPECT_NEAR(distance(line.front(), centre + r * out(begin)), 0, 1e-9);
        EXPECT_NEAR(distance(line.back(), centre + r * out(end)), 0, 1e-9);
        const double off = sweep <= std::numbers::pi / 2 ? 0.001 : 0.02;
        for (std::size_t i = 0; i < line.size(); ++i) {
            EXPECT_NEAR(distance(line[i], centre), r, off * r);
            if (i > 0) {
                EXPECT_LE(distance(line[i - 1], line[i]), 2 * step);
            }
        }
    }
}

} // namespace
} // namespace filum::geom
