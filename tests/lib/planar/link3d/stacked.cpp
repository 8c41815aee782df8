#include "link3d/stacked.hpp"

#include "stacks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace filum::link3d {
namespace {

using test::kHeight;

constexpr double kZ = 1; // mm

double volume(const SpatialBead& l) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < l.points.size(); ++i)
        sum += geom::distance(l.points[i].xy(), l.points[i + 1].xy()) *
               (l.width[i] * l.height[i] + l.width[i + 1] * l.height[i + 1]) / 2;
    return sum;
}

// Up to a wall, along it to its tip and back, and on.
const std::vector<Vec2> kWall{{0, 0}, {4, 0}, {10, 0}};
Bead there_and_back() {
    return {{{0, 5}, {0, 0}, {4, 0}, {10, 0}, {4, 0}, {0, 0}, {0, -5}}, {0.4, 0.15, 0.15, 0.15, 0.15, 0.15, 0.4}};
}

TEST(StackedWalls, TheFirstPassLiesBelowTheSecond) {
    const Bead bead = there_and_back();
    StackedWalls stacked({kWall});
    const auto laid = stacked.lay(bead, kZ, kHeight, 0.2);
    ASSERT_EQ(laid.points.size(), laid.width.size());
    ASSERT_EQ(laid.points.size(), laid.height.size());
    EXPECT_EQ(laid.points.front(), (Vec3{0, 5, kZ}));
    EXPECT_EQ(laid.points.back(), (Vec3{0, -5, kZ}));
    bool back = false;
    for (std::size_t i = 0; i < laid.points.size(); ++i) {
        const Vec3 p = laid.points[i];
        if (p.x > 0.3 && p.x < 9.7) {
            EXPECT_NEAR(p.z, back ? kZ : kZ - kHeight / 2, 1e-12) << i;
            EXPECT_NEAR(laid.width[i], 0.3, 1e-12);
            EXPECT_NEAR(laid.height[i], kHeight / 2, 1e-12);
        }
        back = back || p.x == 10;
    }
    double flat = 0;
    for (std::size_t i = 0; i + 1 < bead.points.size(); ++i)
        flat += geom::distance(bead.points[i], bead.points[i + 1]) * (bead.width[i] + bead.width[i + 1]) / 2 * kHeight;
    EXPECT_NEAR(volume(laid), flat, 0.02 * flat);
}

TEST(StackedWalls, AnyWayRoundAndFromAnyBead) {
    Bead bead = there_and_back();
    std::reverse(bead.points.begin(), bead.points.end());
    StackedWalls stacked({kWall});
    // there as one bead, back as another one
    const Bead there{{bead.points.begin(), bead.points.begin() + 4}, {0.15}},
        back{{bead.points.begin() + 3, bead.points.end()}, {0.15}};
    const auto low = stacked.lay(there, kZ, kHeight, 0.2), high = stacked.lay(back, kZ, kHeight, 0.2);
    EXPECT_NEAR(low.points.back().z, kZ - kHeight / 2, 1e-12);
    for (const auto& p : high.points) EXPECT_NEAR(p.z, kZ, 1e-12);
}

TEST(StackedWalls, WhatOnlyCrossesAWallIsPlain) {
    StackedWalls stacked({kWall});
    const auto laid = stacked.lay({{{5, -3}, {5, 0}, {5, 3}, {6, 3}, {6, 0.1}, {9, 0.1}}, {0.4}}, kZ, kHeight, 0.2);
    EXPECT_EQ(laid.points.size(), 6U);
    for (std::size_t i = 0; i < laid.points.size(); ++i) {
        EXPECT_EQ(laid.points[i].z, kZ);
        EXPECT_EQ(laid.width[i], 0.4);
        EXPECT_EQ(laid.height[i], kHeight);
    }
}

} // namespace
} // namespace filum::link3d
