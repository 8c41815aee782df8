// A window of an area is the intersection with its box.
#include "polygon/cut.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace filum::polygon;

namespace {

// Stars with holes, some overlapping: a union of random loops.
Loops random_area(std::mt19937& random) {
    std::uniform_real_distribution<double> some(0, 1);
    const auto star = [&](double size, Loops& to) {
        const double x = 20 * some(random), y = 20 * some(random);
        for (int k = 0; k < 24; ++k) {
            const double a = 2 * std::numbers::pi * k / 24, r = size * (0.4 + 0.6 * some(random));
            to.points.push_back({x + r * std::cos(a), y + r * std::sin(a)});
        }
        to.close();
    };
    Loops solid, holes;
    for (int k = 0; k < 6; ++k) star(7, solid);
    for (int k = 0; k < 6; ++k) star(2, holes);
    return subtract(unite(solid), unite(holes));
}

} // namespace

TEST(WithinBox, IsTheIntersection) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> at(-5, 25);
    for (int round = 0; round < 300; ++round) {
        const Loops area = random_area(random);
        Box2 box;
        box.add({at(random), at(random)});
        box.add({at(random), at(random)});
        Loops frame;
        frame.add(std::vector<Vec2>{box.lo, {box.hi.x, box.lo.y}, box.hi, {box.lo.x, box.hi.y}});
        const Loops expected = intersect(area, frame), found = within_box(area, box);
        EXPECT_NEAR(signed_area(found), signed_area(expected), 0.01) << round;
        EXPECT_LT(signed_area(subtract(found, expected)), 0.01) << round;
    }
}

TEST(WithinBox, TakesAreasThatAreNotSimple) {
    Loops crossed;
    crossed.add(std::vector<Vec2>{{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    crossed.add(std::vector<Vec2>{{5, 5}, {15, 5}, {15, 15}, {5, 15}});
    EXPECT_NEAR(signed_area(within_box(crossed, {{7, -1}, {20, 20}})), 3 * 10 + 8 * 10 - 3 * 5, 0.01);
}
