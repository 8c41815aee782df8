#include "fill/contour.hpp"

#include "pattern_check.hpp"

namespace filum::fill {
namespace {

using namespace test;

TEST(Contour, RingsLieInsideAndNeverCross) {
    for (unsigned seed = 0; seed < 12; ++seed)
        for (const auto& region : random_regions(seed)) {
            Notes notes;
            const auto rings = contour(region, {}, notes);
            expect_sound(rings);
            for (const auto& r : rings) EXPECT_TRUE(r.closed);
            EXPECT_EQ(crossings(rings), 0U) << seed;
            EXPECT_LT(farthest_outside(region, rings), 0.12) << seed; // acute tips may be moved a little
        }
}

TEST(Contour, PlainRingsLieAtOddMultiplesOfHalfABead) {
    for (const auto& [name, region] : hard_regions()) {
        Notes notes;
        for (const auto& ring : contour(region, {.fit = false}, notes)) {
            const double w = ring.width[0];
            for (const Vec2 p : ring.points) {
                const double k = distance_to_outline(region, p) / w + 0.5;
                EXPECT_NEAR(k, std::round(k), 0.03) << name;
            }
        }
    }
}

TEST(Contour, FitsAnyThicknessEvenly) {
    for (double side = 2; side < 6; side += 0.37) { // beads of a long bar share its thickness
        Notes notes;
        const auto bar = rectangle(0, 0, 60, side);
        const auto rings = contour(bar, {}, notes);
        EXPECT_NEAR(laid(rings) / (60 * side), 1, 0.015) << side;
        EXPECT_GT(coverage(bar, rings, 0.03), 0.98) << side;
    }
}

TEST(Contour, CountsRings) {
    Notes notes;
    EXPECT_EQ(contour(rectangle(0, 0, 10, 10), {.rings = 3}, notes).size(), 3U);
    EXPECT_EQ(contour(polygon::subtract(disc({0, 0}, 8), disc({0, 0}, 3)), {.rings = 2}, notes).size(), 4U);
    EXPECT_EQ(contour(rectangle(0, 0, 10, 10), {.rings = 1, .fit = false}, notes)[0].width[0], 0.4);
    EXPECT_TRUE(notes.empty());
}

TEST(Contour, PlainRingsSayWhatIsTooThinForThem) {
    Notes notes;
    const auto flag = polygon::unite(rectangle(0, 0, 4, 4), rectangle(3.9, 0, 10, 0.3));
    EXPECT_FALSE(contour(flag, {.fit = false}, notes).empty());
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NEAR(notes[0].amount, 1.8, 0.1);
    EXPECT_GT(notes[0].x, 3.9);
    Notes more;
    EXPECT_TRUE(contour(rectangle(0, 0, 10, 0.35), {.fit = false}, more).empty());
    ASSERT_EQ(more.size(), 1U);
    EXPECT_NEAR(more[0].amount, 3.5, 0.01);
}

TEST(Contour, FittedRingsFollowThinWalls) {
    Notes notes;
    const auto flag = polygon::unite(rectangle(0, 0, 4, 4), rectangle(3.9, 0, 10, 0.3));
    EXPECT_GT(coverage(flag, contour(flag, {}, notes)), 0.97);
    EXPECT_TRUE(notes.empty());
}

TEST(Contour, CoversHardRegions) {
    for (const auto& [name, region] : hard_regions()) {
        Notes notes;
        EXPECT_GT(coverage(region, contour(region, {}, notes)), 0.96) << name;
    }
}

TEST(Contour, IsRepeatable) {
    Notes notes;
    const auto region = random_regions(3).at(0);
    EXPECT_TRUE(same(contour(region, {}, notes), contour(region, {}, notes)));
}

} // namespace
} // namespace filum::fill
