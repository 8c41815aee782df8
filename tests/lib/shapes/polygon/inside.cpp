// Gives what contains() gives.
#include "polygon/inside_test.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace filum::polygon;

TEST(InsideTest, AgreesWithContains) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> some(0, 1);
    for (int round = 0; round < 50; ++round) {
        Loops area; // loops of any kind, with points on whole numbers, too
        for (int l = 0; l < 1 + round % 7; ++l) {
            for (int k = 0; k < 3 + round; ++k) {
                const double x = 20 * some(random), y = 20 * some(random);
                area.points.push_back(round % 2 == 0 ? Vec2{x, y} : Vec2{std::round(x), std::round(y)});
            }
            area.close();
        }
        const InsideTest inside(area);
        for (int k = 0; k < 500; ++k) {
            const double x = 24 * some(random) - 2, y = 24 * some(random) - 2;
            const Vec2 p = k % 2 == 0 ? Vec2{x, y} : Vec2{std::round(x), std::round(y)};
            EXPECT_EQ(inside(p), contains(area, p)) << round << ": " << p.x << ' ' << p.y;
        }
    }
    EXPECT_FALSE(InsideTest(Loops{})({0, 0}));
}
