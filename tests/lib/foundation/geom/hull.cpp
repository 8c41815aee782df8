#include "geom/hull.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace filum::geom;

TEST(Hull, HoldsAllPointsAndTurnsLeftAtEachCorner) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 200; ++trial) {
        std::uniform_int_distribution<int> at(0, trial % 2 == 0 ? 6 : 1000); // many on lines, or few
        std::vector<Vec2> points;
        for (int k = 0; k < 3 + trial % 40; ++k)
            points.push_back({static_cast<double>(at(random)), static_cast<double>(at(random))});
        const auto hull = convex_hull(points);
        if (hull.size() < 3) {
            for (const Vec2& p : points) EXPECT_EQ(orient(hull.front(), hull.back(), p), 0);
            continue;
        }
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const Vec2 a = hull[i], b = hull[(i + 1) % hull.size()];
            EXPECT_GT(orient(a, b, hull[(i + 2) % hull.size()]), 0);
            for (const Vec2& p : points) EXPECT_GE(orient(a, b, p), 0);
        }
    }
}

} // namespace
