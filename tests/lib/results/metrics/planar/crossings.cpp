#include "metrics/planar/crossings.hpp"

#include "toolpaths.hpp"

#include <random>

namespace filum::metrics::planar {

namespace {

// The definition, pair by pair.
std::size_t brute(const std::vector<Bead>& beads) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < beads.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const Bead &s = beads[j], &t = beads[i];
            if (t.order - s.order <= 1) continue;
            bool both = true; // each has its ends on both sides of the other, half a micrometre and more from it
            for (const auto& [line, ends] : {std::pair{s, t}, std::pair{t, s}}) {
                const double length = geom::distance(line.a, line.b), a = geom::orient(line.a, line.b, ends.a) / length,
                             b = geom::orient(line.a, line.b, ends.b) / length;
                both = both && a * b < 0 && std::min(std::abs(a), std::abs(b)) > 0.5e-3;
            }
            n += both ? 1 : 0;
        }
    }
    return n;
}

TEST(Crossings, AreFoundLikePairByPair) {
    std::mt19937 random(3);
    for (const double length : {0.05, 1.0, 30.0}) {
        std::uniform_real_distribution<double> place(0, 20), step(-length, length);
        for (int trial = 0; trial < 10; ++trial) {
            std::vector<Bead> beads;
            Vec2 at{place(random), place(random)};
            for (std::uint32_t k = 0; k < 400; ++k) {
                const Vec2 to = at + Vec2{step(random), step(random)};
                beads.push_back({at, to, 0.4, k % 3, k});
                at = k % 50 == 49 ? Vec2{place(random), place(random)} : to;
            }
            const Crossings c = crossings(beads, 3);
            EXPECT_EQ(c.whole, brute(beads)) << length;
            EXPECT_LE(c.slot[0] + c.slot[1] + c.slot[2], c.whole);
            EXPECT_EQ(c.place.size(), std::min<std::size_t>(16, c.whole));
        }
    }
}

TEST(Crossings, TouchingIsNone) {
    // A T, a V, and two beads on one line.
    const std::vector<Bead> beads{{{0, 0}, {4, 0}, 0.4, 0, 0},
                                  {{2, 0}, {2, 3}, 0.4, 0, 5},
                                  {{4, 0}, {5, 5}, 0.4, 0, 9},
                                  {{1, 0}, {3, 0}, 0.4, 0, 12}};
    EXPECT_EQ(crossings(beads, 1).whole, 0);
    // An end that rounding has put on the other side, at any angle.
    for (const double across : {0.0, 0.3, -2.0}) {
        EXPECT_EQ(crossings(std::vector<Bead>{{{0, 0}, {4, 0}, 0.4, 0, 0}, {{2, -4e-4}, {2 + across, 3}, 0.4, 0, 5}}, 1)
                      .whole,
                  0);
        EXPECT_EQ(crossings(std::vector<Bead>{{{0, 0}, {4, 0}, 0.4, 0, 0}, {{2, -1e-3}, {2 + across, 3}, 0.4, 0, 5}}, 1)
                      .whole,
                  1);
    }
}

TEST(Crossings, OnGridLinesCountOnce) {
    std::vector<Bead> beads;
    for (std::uint32_t k = 0; k < 10; ++k) {
        beads.push_back({{k + 0.0, -1}, {k + 0.0, 10}, 0.4, 0, 4 * k});
        beads.push_back({{-1, k + 0.0}, {10, k + 0.0}, 0.4, 0, 4 * k + 2});
    }
    EXPECT_EQ(crossings(beads, 1).whole, 100);
    for (Bead& b : beads) b.a = b.a + Vec2{1e7, -1e7}, b.b = b.b + Vec2{1e7, -1e7};
    EXPECT_EQ(crossings(beads, 1).whole, 100);
}

// At 0.1 mm, laid so thick, and at 0.2 mm, the rest of the layer.
TEST(Crossings, WhatLiesOverDoesNot) {
    std::vector<Bead> beads{{{0, 0}, {2, 2}, 0.4, 0, 0, 0.0F, 0.2F, 0.5F},
                            {{0, 2}, {2, 0}, 0.4, 0, 5, 0.2F, 0.2F, 0.5F}};
    EXPECT_EQ(crossings(beads, 1, 0.2).whole, 0);
    std::swap(beads[0].order, beads[1].order);
    EXPECT_EQ(crossings(beads, 1, 0.2).whole, 1) << "the nozzle runs below what was laid";
    std::swap(beads[0].order, beads[1].order);
    beads[1].thick = 0.7F;
    EXPECT_EQ(crossings(beads, 1, 0.2).whole, 1) << "laid thicker than there is room for";
    beads[0].thick = 0.05F;
    EXPECT_EQ(crossings(beads, 1, 0.2).whole, 0) << "over a film of hardly anything";
    EXPECT_EQ(crossings(beads, 1).whole, 1);
}

TEST(Crossings, OfFollowersDoNotCount) {
    const std::vector<Bead> beads{
        {{0, 0}, {2, 2}, 0.4, 0, 0}, {{0, 2}, {2, 0}, 0.4, 0, 1}, {{1, 3}, {1.1, -1}, 0.4, 0, 2}};
    const Crossings c = crossings(beads, 1);
    ASSERT_EQ(c.whole, 1);
    EXPECT_NEAR(c.place[0].x, c.place[0].y, 1e-12);
}

} // namespace

} // namespace filum::metrics::planar
