#include "absorb/tile.hpp"
#include "absorb/voids.hpp"
#include "polygon/segments.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum {
namespace {

using absorb::Bead;
using absorb::Mask;
using absorb::Pixel;
using absorb::Tile;
using geom::Vec2;

polygon::Loops square(double side) {
    polygon::Loops out;
    out.add(std::vector<Vec2>{{0, 0}, {side, 0}, {side, side}, {0, side}});
    return out;
}

std::vector<Bead> random_beads(std::mt19937& random, int n) {
    std::uniform_real_distribution<double> place(0, 4), width(0.05, 1);
    std::vector<Bead> out;
    for (int k = 0; k < n; ++k)
        out.push_back({{place(random), place(random)}, {place(random), place(random)}, width(random)});
    return out;
}

TEST(Tile, KnowsTheRegionWithItsHoles) {
    polygon::Loops region = square(4);
    region.add(std::vector<Vec2>{{1, 1}, {1, 2}, {2, 2}, {2, 1}});
    const Tile tile(polygon::segments(region), {{-1, -1}, {5, 5}}, 0.05);
    for (const auto& [p, inside] : {std::pair{Vec2{0.5, 0.5}, true},
                                    {{1.5, 1.5}, false},
                                    {{-0.5, 2}, false},
                                    {{3.9, 3.9}, true},
                                    {{4.1, 2}, false},
                                    {{2.1, 1.5}, true}})
        EXPECT_EQ(tile.inside(tile.at(p)), inside) << p.x << ',' << p.y;
    const auto counts = tile.count({0, 0}, {tile.width() - 1, tile.height() - 1});
    EXPECT_NEAR(static_cast<double>(counts.inside) * 0.05 * 0.05, 15, 0.01);
    EXPECT_EQ(counts.empty, counts.inside);
}

// By the definition of a bead: all points within half a width of the segment.
TEST(Tile, StampsThePixelsOfABead) {
    std::mt19937 random(3);
    const Tile tile(polygon::segments(square(4)), {{0, 0}, {4, 4}}, 4.0 / 63);
    for (const Bead& b : random_beads(random, 200)) {
        Mask mask;
        tile.stamp(b, {0, 0}, mask);
        for (int y = 0; y < 64; ++y)
            for (int x = 0; x < 64; ++x) {
                const double d = geom::point_segment_distance(b.a, b.b, tile.centre({x, y}));
                if (std::abs(d - b.width / 2) < 1e-9) continue; // on the very border
                EXPECT_EQ((mask.rows[static_cast<std::size_t>(y)] >> x & 1) != 0, d < b.width / 2);
            }
    }
}

TEST(Tile, TellsWhatIsBareWithoutSomeBeads) {
    std::mt19937 random(5);
    for (int run = 0; run < 20; ++run) {
        const auto beads = random_beads(random, 12);
        Tile all(polygon::segments(square(3)), {{0, 0}, {4, 4}}, 4.0 / 63), rest = all;
        for (std::size_t k = 0; k < beads.size(); ++k) {
            all.add(beads[k], 1);
            if (k >= 5) rest.add(beads[k], 1);
        }
        Mask in, out, in_rest, out_rest;
        all.uncovered({0, 0}, {beads.data(), 5}, in, out);
        rest.uncovered({0, 0}, {}, in_rest, out_rest);
        EXPECT_EQ(in.rows, in_rest.rows);
        EXPECT_EQ(out.rows, out_rest.rows);
        for (const Bead& b : beads) all.add(b, -1);
        EXPECT_EQ(all.count({0, 0}, {63, 63}).empty, all.count({0, 0}, {63, 63}).inside);
    }
}

TEST(Voids, AreWhatTheBeadsLeave) {
    Tile tile(polygon::segments(square(4)), {{0, 0}, {4, 4}}, 0.02);
    tile.add({{-1, 2}, {5, 2}, 2}, 1); // a band; bare above and below
    const auto found = absorb::voids(tile, {0, 0}, {tile.width() - 1, tile.height() - 1}, 4, 1000000);
    ASSERT_EQ(found.size(), 2U);
    for (const auto& v : found) EXPECT_NEAR(static_cast<double>(v.pixels.size()) * 0.02 * 0.02, 4, 0.05);
    const auto again = absorb::voids(tile, {0, 0}, {tile.width() - 1, tile.height() - 1}, 4, 500);
    EXPECT_GT(again.size(), 30U); // in pieces, and no pixel is remembered as seen
}

} // namespace
} // namespace filum
