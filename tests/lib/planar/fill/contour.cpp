#include "fill/spiral.hpp"

#include "pattern_check.hpp"

namespace filum::fill {

namespace {

using namespace test;

TEST(Contour, RingsLieInsideAndNeverCross) {
    for (unsigned seed = 0; seed < 12; ++seed)
        for (const auto& region : random_regions(seed)) {
            const auto rings = contour(region, {});
            expect_sound(rings);
            for (const auto& r : rings) EXPECT_TRUE(r.closed);
            EXPECT_EQ(crossings(rings), 0U) << seed;
            EXPECT_LT(farthest_outside(region, rings), 0.12) << seed; // acute tips may be moved a little
        }
}

TEST(Contour, FitsAnyThicknessEvenly) {
    for (double side = 2; side < 6; side += 0.37) { // beads of a long bar share its thickness
        const auto bar = rectangle(0, 0, 60, side);
        const auto rings = contour(bar, {});
        EXPECT_NEAR(laid(rings) / (60 * side), 1, 0.015) << side;
        EXPECT_GT(coverage(bar, rings, 0.03), 0.98) << side;
    }
}

TEST(Contour, CountsRings) {
    EXPECT_EQ(contour(rectangle(0, 0, 10, 10), {.rings = 3}).size(), 3U);
    EXPECT_EQ(contour(polygon::subtract(disc({0, 0}, 8), disc({0, 0}, 3)), {.rings = 2}).size(), 4U);
}

TEST(Contour, FittedRingsFollowThinWalls) {
    const auto flag = polygon::unite(rectangle(0, 0, 4, 4), rectangle(3.9, 0, 10, 0.3));
    EXPECT_GT(coverage(flag, contour(flag, {})), 0.97);
}

TEST(Contour, CoversHardRegions) {
    for (const auto& [name, region] : hard_regions()) {
        EXPECT_GT(coverage(region, contour(region, {})), 0.96) << name;
    }
}

TEST(Contour, IsRepeatable) {
    const auto region = random_regions(3).at(0);
    EXPECT_TRUE(same(contour(region, {}), contour(region, {})));
}

} // namespace
} // namespace filum::fill
