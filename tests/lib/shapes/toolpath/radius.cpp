// The radius that a line turns with at a place.
#include "toolpath/radius.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace filum::toolpath {
namespace {

using geom::Vec2;

TEST(RadiusAt, IsThatOfACircleOpenOrClosed) {
    std::vector<Vec2> circle;
    for (int k = 0; k < 400; ++k) {
        const double angle = 2 * std::numbers::pi * k / 400;
        circle.push_back({3 + 2 * std::cos(angle), 4 + 2 * std::sin(angle)});
    }
    for (std::size_t i = 0; i < circle.size(); ++i) EXPECT_NEAR(radius_at(circle, true, i, 0.2), 2, 0.02);
    for (std::size_t i = 10; i + 10 < circle.size(); ++i) EXPECT_NEAR(radius_at(circle, false, i, 0.2), 2, 0.02);
}

TEST(RadiusAt, TellsStraightLinesCornersAndWaysBack) {
    const std::vector<Vec2> line{{0, 0}, {1, 0}, {5, 0}, {5, 3}, {5, 1}};
    EXPECT_TRUE(std::isinf(radius_at(line, false, 1, 0.5)));
    EXPECT_NEAR(radius_at(line, false, 2, 0.5), 0.5 / std::numbers::sqrt2, 1e-12);
    EXPECT_EQ(radius_at(line, false, 3, 0.5), 0);
    EXPECT_NEAR(radius_at(line, false, 2, 100), std::hypot(5, 1) / 2, 1e-12); // by the ends
}

} // namespace
} // namespace filum::toolpath
