// Tile by tile gives what one piece gives; large inputs stay near linear.
#include "polygon/tiles.hpp"
#include "geom/segment.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace filum::polygon;

namespace {

// A closed wave of n points about the origin with as many round holes as fit on a grid of 4 mm.
Loops plate(std::size_t n, double radius, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> some(0.5, 1.5);
    const double turn = 2 * std::numbers::pi, wave = some(random), teeth = std::round(radius * some(random));
    Loops out;
    for (std::size_t i = 0; i < n; ++i) {
        const double a = turn * static_cast<double>(i) / static_cast<double>(n);
        const double r = radius + wave * std::sin(teeth * a);
        out.points.push_back({r * std::cos(a), r * std::sin(a)});
    }
    out.close();
    for (double y = -radius; y < radius; y += 4)
        for (double x = -radius; x < radius; x += 4) {
            if (std::hypot(x, y) > radius - 4) continue;
            const double r = some(random);
            for (int i = 0; i < 40; ++i)
                out.points.push_back({x + r * std::cos(-turn * i / 40), y + r * std::sin(-turn * i / 40)});
            out.close();
        }
    return out;
}

} // namespace

TEST(Tiled, CopyIsTheSameArea) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const Loops a = plate(9000, 60, seed);
        int tiles = 0;
        const Loops b = tiled({&a, 1}, 0, [&](std::span<const Loops> in) {
            ++tiles;
            EXPECT_LE(in[0].points.size(), 2000U);
            return unite(in[0]); // the pieces of a cut loop hang together
        });
        EXPECT_GT(tiles, 4);
        EXPECT_EQ(b.size(), a.size());
        EXPECT_TRUE(is_simple(b));
        EXPECT_NEAR(signed_area(b), signed_area(a), 0.01); // of 10 000 mm2
    }
}

TEST(Tiled, InsetsAndOutsetsMeetTheStripThatTheyLeave) {
    const Loops a = plate(6000, 40, 4); // far above a tile
    for (const double by : {-0.2, -0.9, 0.3}) {
        const Loops moved = offset(a, by);
        EXPECT_TRUE(is_simple(moved));
        // every corner lies at that distance, or farther where others are near: none nearer
        for (std::size_t i = 0; i < moved.points.size(); i += 421) {
            double nearest = 1e9;
            for (std::size_t l = 0; l < a.size(); ++l)
                for (std::size_t k = 0; k < a[l].size(); ++k)
                    nearest = std::min(nearest, filum::geom::point_segment_distance(
                                                    a[l][k], a[l][(k + 1) % a[l].size()], moved.points[i]));
            ASSERT_NEAR(nearest, std::abs(by), 0.003) << by << " point " << i;
        }
    }
}

TEST(Tiled, HoleInTheCornerOfATileTurnsNothingRound) {
    // a thin ring: most tiles have their corners in its hole
    Loops ring;
    for (const double r : {100.0, -97.0})
        for (int i = 0, n = 8000; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n * (r > 0 ? 1 : -1);
            ring.points.push_back({std::abs(r) * std::cos(a), std::abs(r) * std::sin(a)});
            if (i + 1 == n) ring.close();
        }
    const Loops moved = offset(ring, -0.5);
    ASSERT_EQ(moved.size(), 2U);
    const double pi = std::numbers::pi;
    EXPECT_NEAR(signed_area(moved), pi * (99.5 * 99.5 - 97.5 * 97.5), 0.5);
}

TEST(Tiled, SidesThatDisagreeAreDoneInOnePiece) {
    const Loops a = plate(9000, 60, 5);
    int calls = 0;
    // an operation against the rule: it depends on the size of what it is given
    const Loops b = tiled({&a, 1}, 0, [&](std::span<const Loops> in) {
        ++calls;
        return in[0].points.size() > 2000 ? in[0] : (calls % 2 == 0 ? Loops{} : unite(in[0]));
    });
    EXPECT_NEAR(signed_area(b), signed_area(a), 0.01);
}

// Tooth by tooth, each looking at all others, this would not end in an hour.
TEST(Simplify, CombOfManyTeethKeepsThem) {
    Loops comb;
    constexpr int kTeeth = 100000;
    comb.points.push_back({0, -5});
    comb.points.push_back({4.0 * kTeeth, -5});
    for (int i = kTeeth; i-- > 0;)
        for (const auto& [x, y] : {std::pair{3, 0}, {3, 30}, {1, 30}, {1, 0}})
            comb.points.push_back({4.0 * i + x, 1.0 * y});
    comb.close();
    const Loops out = simplify(comb, 0.01);
    EXPECT_EQ(out.points.size(), comb.points.size());
}

TEST(Tiled, UnionOfManyOverlappingDiscs) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> at(0, 40), size(1, 3);
    struct Disc {
        double x, y, r;
    };
    std::vector<Disc> discs;
    Loops all;
    for (int k = 0; k < 150; ++k) {
        const Disc d{at(random), at(random), size(random)};
        discs.push_back(d);
        for (int i = 0; i < 60; ++i) {
            const double a = 2 * std::numbers::pi * i / 60;
            all.points.push_back({d.x + d.r * std::cos(a), d.y + d.r * std::sin(a)});
        }
        all.close();
    }
    const Loops one = unite(all);
    EXPECT_TRUE(is_simple(one));
    for (int k = 0; k < 2000; ++k) {
        const filum::geom::Vec2 p{at(random), at(random)};
        double deepest = -1; // of the discs' radius
        for (const Disc& d : discs) deepest = std::max(deepest, 1 - std::hypot(p.x - d.x, p.y - d.y) / d.r);
        if (deepest > -0.01 && deepest < 0.01) continue; // a polygon is no disc
        EXPECT_EQ(contains(one, p), deepest > 0) << p.x << ' ' << p.y;
    }
}
