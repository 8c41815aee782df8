// Rings closed by triangles: all of what is within, nothing else.
#include "surface/ring_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace filum::surface {
namespace {

using geom::Vec3;

// Along the outline of a U, in steps, off its straight sides by no more than rounding.
std::vector<Vec3> crooked(unsigned seed) {
    std::mt19937 random(seed);
    const Vec3 corners[] = {{0, 0, 0},   {30, 0, 0},  {30, 20, 0}, {20, 20, 0},
                            {20, 10, 0}, {10, 10, 0}, {10, 20, 0}, {0, 20, 0}};
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < std::size(corners); ++i) {
        const Vec3 &a = corners[i], &b = corners[(i + 1) % std::size(corners)];
        for (int k = 0; k < 20; ++k) {
            const double off = 1e-14 * static_cast<double>(random() % 7) - 3e-14;
            out.push_back(a + k / 20.0 * (b - a) + Vec3{off, off, 0});
        }
    }
    return out;
}

TEST(RingTriangles, FillTheRingWhereSidesAreStraightButForRounding) {
    for (unsigned seed = 0; seed < 50; ++seed) {
        const auto ring = crooked(seed);
        const auto triangles = ring_triangles(ring);
        EXPECT_EQ(triangles.size(), ring.size() - 2) << seed;
        double area = 0; // the ring is to their right
        for (const auto& [a, b, c] : triangles) area -= cross(ring[b] - ring[a], ring[c] - ring[a]).z / 2;
        EXPECT_NEAR(area, 500, 1e-9) << seed;
    }
}

TEST(RingTriangles, NoneInARingThatCrossesItself) {
    EXPECT_TRUE(
        ring_triangles(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 1, 0}, {1, 0, 0}, {0, 1, 0}}).empty());
    EXPECT_TRUE(ring_triangles(std::vector<Vec3>{{0, 0, 0}, {1, 1, 0}}).empty());
}

} // namespace
} // namespace filum::surface
