// Lines put on the grid of machines, where they cross nothing.
#include "toolpath/grid.hpp"

#include <gtest/gtest.h>

namespace filum::toolpath {
namespace {

Curve line(std::vector<Vec2> points, bool closed = false) { return {closed, std::move(points), {0.4}}; }

TEST(Grid, PointsThatFallTogetherAreOne) {
    Curve ring{true, {{0, 0}, {1, 0.0004}, {1.0002, 0}, {1, 1}, {0, 0.0001}}, {.1, .2, .3, .4, .5}};
    put_on_grid(ring);
    EXPECT_EQ(ring.points, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}}));
    EXPECT_EQ(ring.width, (std::vector{.1, .2, .4}));
    Curve speck = line({{0, 0}, {0.0001, 0.0001}});
    put_on_grid(speck);
    EXPECT_EQ(speck.points.size(), 2U) << "less than a line";
}

// A line that touches another one from its side, and goes back: rounded, its point lies on the other side.
TEST(Grid, WhatOnlyTouchedIsPartedByAMicrometre) {
    std::vector<Curve> curves{line({{0, 0}, {1, 0.333}}), line({{0, 0.4}, {0.503, 0.167499}, {1, 0.5}})};
    EXPECT_TRUE(crossing_pairs(curves, 0.4).empty());
    for (Curve& c : curves) put_on_grid(c);
    ASSERT_EQ(crossing_pairs(curves, 0.4).size(), 2U);
    EXPECT_TRUE(part_crossings(curves, 0.4).empty());
    EXPECT_TRUE(crossing_pairs(curves, 0.4).empty());
    const std::vector<Vec2> before{{0, 0}, {1, 0.333}, {0, 0.4}, {0.503, 0.167}, {1, 0.5}};
    std::vector<Vec2> after = curves[0].points;
    after.insert(after.end(), curves[1].points.begin(), curves[1].points.end());
    int moved = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        EXPECT_EQ(after[i], on_grid(after[i]));
        EXPECT_LE(geom::distance(before[i], after[i]), 0.0011);
        moved += before[i] == after[i] ? 0 : 1;
    }
    EXPECT_EQ(moved, 1);
}

TEST(Grid, RingsArePartedWhereTheyClose) {
    std::vector<Curve> curves{line({{0.5, -0.001}, {1, 1}, {0, 1}}, true), line({{-1, 0}, {2, 0}})};
    ASSERT_EQ(crossing_pairs(curves, 0.4).size(), 2U);
    EXPECT_TRUE(part_crossings(curves, 0.4).empty());
    EXPECT_LE(geom::distance(curves[0].points[0], {0.5, -0.001}), 0.0011);
}

TEST(Grid, WhatIsFixedStays) {
    const Vec2 place{0.5, 0.502};
    std::vector<Curve> cross{line({{0, 0.5}, {1, 0.5}}), line({{0, 1}, place, {0.6, 0.499}, {1, 1}})};
    ASSERT_EQ(crossing_pairs(cross, 0.4).size(), 2U);
    EXPECT_TRUE(part_crossings(cross, 0.4, place).empty());
    EXPECT_EQ(cross[1].points[1], place);
}

// What crosses by more than beads' edges may be off is left, and is as it was.
TEST(Grid, RealCrossingsAreLeft) {
    std::vector<Curve> curves{line({{0, 0}, {2, 0}}), line({{1, -1}, {1, 1}})};
    const auto left = part_crossings(curves, 0.4);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0], (std::pair<std::uint32_t, std::uint32_t>{0, 1}));
    EXPECT_EQ(curves[1].points, (std::vector<Vec2>{{1, -1}, {1, 1}}));
}

} // namespace
} // namespace filum::toolpath
