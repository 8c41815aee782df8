#include "regions/air.hpp"
#include "../../trials.hpp"
#include "regions/overlaps.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum::regions {
namespace {

constexpr CarrierOptions kBeads{0.4, 0.04};

Air hung(std::vector<polygon::Region>& upper, const std::vector<polygon::Region>& lower) {
    Air air;
    hang(upper, lower, overlap(upper, lower, kBeads.bead_width, kBeads.hairline), kBeads, air);
    return air;
}

Air hung(const Loops& upper, const std::vector<Loops>& lower) {
    auto above = layer_of({upper}, 10);
    return hung(above, layer_of(lower, 0));
}

TEST(Air, AnOverhangIsMeasuredFromHalfABeadOn) {
    const Air air = hung(box(0, 0, 40, 10), {box(15, 0, 10, 10)}); // a T
    EXPECT_NEAR(air.area, 2 * 10 * (15 - 0.2), 0.02);
    EXPECT_NEAR(air.reach, 15, 0.05);
    EXPECT_EQ(air.bridge, 0);
    EXPECT_EQ(air.layers, 1U);
    EXPECT_EQ(hung(box(0, 0, 10, 10), {box(0.2, 0.2, 9.6, 9.6)}).layers, 0U); // half a bead is no overhang
    EXPECT_EQ(hung(box(0, 0, 10, 10), {box(0, 0, 10, 10)}).layers, 0U);
}

TEST(Air, ABridgeIsTheShortestWayOver) {
    const Air deck = hung(box(0, 0, 40, 5), {box(0, 0, 10, 5), box(30, 0, 10, 5)});
    EXPECT_NEAR(deck.area, 5 * (20 - 0.4), 0.02);
    EXPECT_NEAR(deck.reach, 10, 0.05);
    EXPECT_NEAR(deck.bridge, 20, 0.01);
    Loops cup = box(0, 0, 30, 12);
    add_box(cup, 2, 2, 26, 8, true);
    const Air lid = hung(box(0, 0, 30, 12), {cup});
    EXPECT_NEAR(lid.reach, 4, 0.05);
    EXPECT_NEAR(lid.bridge, 8, 0.05);
}

TEST(Air, NothingBelowIsTold) {
    const Air air = hung(box(0, 0, 2, 2), {});
    EXPECT_NEAR(air.area, 4, 1e-6);
    EXPECT_FALSE(std::isfinite(air.reach));
    EXPECT_TRUE(note(air));
    EXPECT_FALSE(note(Air{}));
}

double distance_to(const std::vector<polygon::Region>& regions, Vec2 p) {
    double best = 1e9;
    for (const auto& r : regions) {
        if (polygon::contains(r.loops, p)) return 0;
        for (std::size_t l = 0; l < r.loops.size(); ++l)
            for (std::size_t i = 0, n = r.loops[l].size(); i < n; ++i)
                best = std::min(best, geom::point_segment_distance(r.loops[l][i], r.loops[l][(i + 1) % n], p));
    }
    return best;
}

// Against points on a grid, each asked for its distance to the layer below.
TEST(Air, AgreesWithAGridOfPoints) {
    Random random(5);
    for (int trial = 0; trial < trials(30); ++trial) {
        std::vector<Loops> sides[2];
        for (auto& s : sides) {
            Loops soup;
            for (int i = 0; i < 6; ++i) soup.add(random_star(random, 12, 1, 4, 9));
            s = polygon::split(soup).part;
        }
        const auto lower = layer_of(sides[0], 0);
        auto upper = layer_of(sides[1], 100);
        const Air air = hung(upper, lower);
        constexpr double kStep = 0.05;
        double area = 0, reach = 0;
        std::vector<double> of(upper.size(), 0);
        for (double x = -4; x < 16; x += kStep)
            for (double y = -4; y < 16; y += kStep)
                for (std::size_t u = 0; u < upper.size(); ++u)
                    if (polygon::contains(upper[u].loops, {x, y})) {
                        const double d = distance_to(lower, {x, y});
                        if (d > kBeads.bead_width / 2) {
                            area += kStep * kStep;
                            of[u] += kStep * kStep;
                        }
                        reach = std::max(reach, d);
                    }
        EXPECT_NEAR(air.area, area, 0.02 * area + 0.3) << trial;
        EXPECT_NEAR(air.reach, reach, 0.1) << trial;
        for (std::size_t u = 0; u < upper.size(); ++u) EXPECT_NEAR(upper[u].unsupported, of[u], 0.02 * of[u] + 0.15);
    }
}

} // namespace
} // namespace filum::regions
