#include "metrics/planar/cover.hpp"

#include "../../../trials.hpp"
#include "metrics/planar/layers.hpp"
#include "toolpaths.hpp"

#include <random>

namespace filum::metrics::planar {

namespace {

constexpr double kPi = std::numbers::pi;

Cover one(const std::vector<Bead>& beads, const polygon::Loops& part, double spacing) {
    const polygon::Loops* outline = &part;
    return cover(beads, {&outline, 1}, spacing).whole;
}

TEST(Cover, OfABeadIsAStadium) {
    for (const double angle : {0.0, 0.3, 0.7853981633974483, 1.3, 1.5707963267948966, 2.9}) {
        const Vec2 d{3 * std::cos(angle), 3 * std::sin(angle)};
        const Cover c = one({{{0, 0}, d, 0.5, 0, 0}}, box(-9, -9, 9, 9), 0.5 / 32);
        EXPECT_NEAR(c.united, 3 * 0.5 + kPi * 0.25 * 0.25, 2e-3) << angle;
        EXPECT_NEAR(c.covered, c.united, 1e-12);
        EXPECT_NEAR(c.area, 324, 1e-9);
        EXPECT_DOUBLE_EQ(c.deposited, 1.5);
        EXPECT_NEAR(c.overfill(), -kPi / 16, 2e-3); // the round ends
    }
}

TEST(Cover, BeadsThatMeetLeaveNoGap) {
    // Ten beads side by side, whose borders fall on round numbers: a raster of pixel centres would be off by a row
    // each.
    for (const double at : {0.0, 17.3, 1e6}) {
        std::vector<Bead> beads;
        for (std::uint32_t k = 0; k < 10; ++k)
            beads.push_back({{at, at + 0.2 + 0.4 * k}, {at + 8, at + 0.2 + 0.4 * k}, 0.4, 0, 2 * k});
        const Cover c = one(beads, box(at, at, at + 8, at + 4), 0.025);
        EXPECT_NEAR(c.area, 32, 1e-6);
        EXPECT_NEAR(c.covered / c.area, 1, 1e-6) << at;
        EXPECT_NEAR(c.outside(), 10 * kPi * 0.04, 0.01); // the round ends
        EXPECT_NEAR(c.deposited, 32, 1e-6);
    }
}

TEST(Cover, OfADiscByRings) {
    std::vector<Bead> beads; // radii 0.2, 0.6, ... 4.6 of a disc of 4.8: full, except for what chords cut off
    std::uint32_t order = 0;
    for (double r = 0.2; r < 4.8; r += 0.4, order += 2)
        for (int k = 0; k < 360; ++k) {
            const double a = 2 * kPi * k / 360, b = 2 * kPi * (k + 1) / 360;
            beads.push_back({{r * std::cos(a), r * std::sin(a)}, {r * std::cos(b), r * std::sin(b)}, 0.4, 0, order++});
        }
    const Cover full = one(beads, disc({0, 0}, 4.8), 0.025);
    EXPECT_NEAR(full.area, kPi * 4.8 * 4.8, 5e-3);
    EXPECT_NEAR(full.covered / full.area, 1, 2e-4);
    EXPECT_NEAR(full.outside(), 0, 0.01);
    beads.erase(beads.begin() + 5 * 360, beads.begin() + 6 * 360); // the ring from 2.0 to 2.4 is missing
    const Cover holed = one(beads, disc({0, 0}, 4.8), 0.025);
    EXPECT_NEAR(holed.unplaced(), kPi * (2.4 * 2.4 - 2.0 * 2.0), 0.02);
}

TEST(Cover, HolesAndIslandsCountEvenOdd) {
    polygon::Loops part = box(0, 0, 10, 10);
    const std::vector<Vec2> hole{{2, 2}, {2, 8}, {8, 8}, {8, 2}};
    part.add(hole);
    const Cover c = one({{{-1, 5}, {11, 5}, 2, 0, 0}}, part, 0.05);
    EXPECT_NEAR(c.area, 64, 1e-9);
    EXPECT_NEAR(c.covered, 8, 1e-6);
    EXPECT_NEAR(c.outside(), 12 + 2 * 2 + kPi, 0.05); // over the hole, beyond the part, the ends
}

TEST(Cover, TellsSlotsApart) {
    const auto left = box(0, 0, 2, 2), right = box(3, 0, 5, 2);
    const polygon::Loops* outline[] = {&left, &right, nullptr};
    // The first bead lies over both but claims the left one; the third claims what has no outline.
    const std::vector<Bead> beads{{{0, 1}, {5, 1}, 1, 0, 0}, {{3, 1}, {5, 1}, 1, 1, 2}, {{9, 1}, {9, 2}, 1, 2, 4}};
    const LayerCover c = cover(beads, outline, 0.02);
    EXPECT_NEAR(c.slot[0].covered, 2, 1e-9);
    EXPECT_NEAR(c.slot[1].covered, 2, 1e-9);
    EXPECT_EQ(c.slot[2].area, 0);
    EXPECT_NEAR(c.whole.covered, 4, 1e-9);
    EXPECT_NEAR(c.whole.overfill(), 2 - 2 * kPi / 4, 5e-3); // overlap on the right one, less the round ends
}

TEST(Cover, HoldsForAnyBeads) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-3, 13), width(0.1, 1.5);
    const auto part = disc({5, 5}, 4);
    for (int trial = 0; trial < 20; ++trial) {
        std::vector<Bead> beads;
        for (std::uint32_t k = 0; k < 30; ++k)
            beads.push_back({{place(random), place(random)}, {place(random), place(random)}, width(random), 0, 2 * k});
        const Cover coarse = one(beads, part, 0.05), fine = one(beads, part, 0.01);
        EXPECT_NEAR(coarse.covered, fine.covered, 0.05);
        EXPECT_NEAR(coarse.united, fine.united, 0.2);
        EXPECT_LE(fine.covered, fine.area);
        EXPECT_GE(fine.outside(), -1e-9);
        // Monte Carlo, by another rule: distance to the nearest bead.
        int both = 0;
        constexpr int kShots = 20000;
        for (int k = 0; k < kShots; ++k) {
            const Vec2 p{place(random), place(random)};
            const bool under = std::any_of(beads.begin(), beads.end(), [&](const Bead& b) {
                const Vec2 d = b.b - b.a;
                const double t = std::clamp(dot(p - b.a, d) / norm2(d), 0.0, 1.0);
                return geom::distance(p, b.a + t * d) <= b.width / 2;
            });
            both += under && geom::distance(p, {5, 5}) <= 4 ? 1 : 0;
        }
        EXPECT_NEAR(256.0 * both / kShots, fine.covered, 4);
    }
}

// Long rows, rings and stray beads in outlines with holes, near and far apart: tiles and rows alone agree.
TEST(Cover, TilesAgreeWithRows) {
    constexpr double kFine = 0.0025; // no bead is level: rows are off by half of this at a level edge
    std::mt19937 random(4);
    const auto uniform = [&](double lo, double hi) {
        return lo + (hi - lo) * static_cast<double>(random()) / 4294967296.0;
    };
    const auto on_grid = [](Vec2 p) { return Vec2{std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3}; };
    for (int k = 0; k < trials(6); ++k) {
        const double size = uniform(40, 90), apart = uniform(0.2, 4), turn = k % 3 == 0 ? 0.02 : uniform(0.02, 3);
        const Vec2 u{std::cos(turn), std::sin(turn)}, v = geom::left_of(u);
        std::vector<Bead> beads;
        const auto add = [&](Vec2 a, Vec2 b) { beads.push_back({on_grid(a), on_grid(b), 0.4, 0, 0}); };
        for (double s = -size / 2; s < size / 2; s += apart) {
            const double half = size / 2 - uniform(0, 2);
            add(s * v - half * u, s * v + half * u);
        }
        for (double r = size / 2 + 4; r < size / 2 + 6; r += 0.4) { // rings that touch
            const Vec2 corner[] = {{-r, -r}, {r, -r}, {r, r}, {-r, r}};
            for (std::size_t i = 0; i < 4; ++i)
                add(corner[i].x * u + corner[i].y * v, corner[(i + 1) % 4].x * u + corner[(i + 1) % 4].y * v);
        }
        for (int i = 0; i < k % 4; ++i)
            add({uniform(-size, size), uniform(-size, size)}, {uniform(-size, size), uniform(-size, size)});
        polygon::Loops outline = box(-size / 2 - 6.2, -size / 2 - 6.2, size / 2 + 6.2, size / 2 + 6.2);
        const double hole = uniform(1, size / 3);
        outline.add(std::vector<Vec2>{{hole, 0}, {0, -hole}, {-hole / 3, 0}, {0, hole}});
        const polygon::Loops* outlines[] = {&outline, nullptr};
        const Cover by_rows = cover(beads, outlines, kFine).slot[0], by_tiles = one(beads, outline, kFine);
        EXPECT_NEAR(by_tiles.area, by_rows.area, 5e-5 * by_rows.area) << k;
        EXPECT_NEAR(by_tiles.united, by_rows.united, 5e-5 * by_rows.united) << k;
        EXPECT_NEAR(by_tiles.covered, by_rows.covered, 5e-5 * by_rows.covered) << k;
        EXPECT_NE(by_tiles.united, by_rows.united) << k; // tiles were made
    }
}

TEST(Cover, OfNothing) {
    EXPECT_EQ(one({}, box(0, 0, 2, 1), 0.1).covered, 0);
    EXPECT_NEAR(one({}, box(0, 0, 2, 1), 0.1).area, 2, 1e-9);
    const Cover c = cover({}, {}, 0.1).whole;
    EXPECT_EQ(c.area, 0);
    EXPECT_EQ(c.united, 0);
    EXPECT_EQ(coverage(c), 1);
}

TEST(Cover, SpacingGrowsRatherThanRowsWithoutEnd) {
    const Cover c = one({{{0, -1e8}, {0, 1e8}, 1, 0, 0}}, box(-1, -1, 1, 1), 1e-3);
    EXPECT_NEAR(c.united / 2e8, 1, 1e-3);
}

} // namespace

} // namespace filum::metrics::planar
