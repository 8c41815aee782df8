#include "polygon/loops.hpp"

#include <gtest/gtest.h>

namespace filum::polygon {
namespace {

TEST(Loops, CentroidIsThatOfTheArea) {
    Loops l; // a square of 4 with a square hole of 2 in a corner, far from the origin
    l.add(std::vector<Vec2>{{1000, 0}, {1004, 0}, {1004, 4}, {1000, 4}});
    EXPECT_EQ(centroid(l), (Vec2{1002, 2}));
    l.add(std::vector<Vec2>{{1000, 0}, {1000, 2}, {1002, 2}, {1002, 0}});
    const Vec2 c = centroid(l);
    EXPECT_NEAR(c.x, 1000 + (16 * 2 - 4 * 1) / 12.0, 1e-9);
    EXPECT_NEAR(c.y, (16 * 2 - 4 * 1) / 12.0, 1e-9);
}

TEST(Loops, CentroidOfNoAreaIsTheFirstPoint) {
    Loops flat;
    flat.add(std::vector<Vec2>{{3, 4}, {5, 4}, {7, 4}});
    EXPECT_EQ(centroid(flat), (Vec2{3, 4}));
    EXPECT_EQ(centroid(Loops{}), Vec2{});
}

} // namespace
} // namespace filum::polygon
