// Distances of outlines agree with those of every pair of edges, at a small share of the work.
#include "worlds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace filum::sequence {
namespace {

TEST(Outline, DistancesAgreeWithEveryPairOfEdges) {
    Random random(2);
    int touching = 0, boxed = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const auto ragged = [&] {
            polygon::Loops soup;
            const double x = uniform(random, 0, 20), y = uniform(random, 0, 20);
            for (int i = 0; i < 6; ++i) {
                const geom::Vec2 off{uniform(random, 0, 2), uniform(random, 0, 2)};
                const geom::Vec2 sides{uniform(random, 0.5, 2), uniform(random, 0.5, 2)};
                soup.add(box(x + off.x, y + off.y, sides.x, sides.y)[0]);
            }
            return polygon::split(soup).part[0];
        };
        const auto a = ragged(), b = ragged();
        const Outline oa = outline(a), ob = outline(b);
        const double d = plain_distance(a, b);
        EXPECT_NEAR(distance(oa, ob), d, 1e-9);
        EXPECT_TRUE(within(oa, ob, {d + 1e-6, 0, 0, false}));
        EXPECT_TRUE(d == 0 || !within(oa, ob, {d - 1e-6, 0, 0, false}));
        touching += d == 0 ? 1 : 0;
        polygon::Loops grown;
        for (const auto p : a.points) grown.add(box(p.x - 3, p.y - 2, 6, 4)[0]);
        const bool meets = overlap(polygon::unite(grown), b); // ragged outlines are no larger than the box: corners do
        EXPECT_EQ(within(oa, ob, {0, 3, 2, false}), meets) << trial;
        boxed += meets ? 1 : 0;
        for (const double limit : {0.1, 1.0, 5.0, 20.0}) {
            const Bounds near = distance_bounds(oa, ob, limit);
            EXPECT_EQ(near.most < limit, d < limit);
            EXPECT_LE(near.least, d + 1e-9);
            EXPECT_GE(near.most, d - 1e-9);
            EXPECT_EQ(near.most < limit, near.least < limit);
        }
        const Bounds seen = carriage_bounds(oa, ob, 3, 2);
        EXPECT_EQ(seen.most < 2, meets) << trial;
        EXPECT_LE(seen.least, d + 1e-9);
        EXPECT_TRUE(within(oa, ob, {0, 1.5 * seen.most + 1e-6, seen.most + 1e-6, false}));
        EXPECT_TRUE(seen.least == 0 || !within(oa, ob, {0, 1.5 * seen.least - 1e-6, seen.least - 1e-6, false}));
    }
    EXPECT_GT(touching, 5);
    EXPECT_GT(boxed, 40);
}

TEST(Outline, OneInsideTheOtherIsAtDistanceZeroAndOneInItsHoleIsNot) {
    polygon::Loops ring = box(0, 0, 10, 10);
    ring.add(std::vector<geom::Vec2>{{2, 2}, {2, 8}, {8, 8}, {8, 2}});
    EXPECT_EQ(distance(outline(ring), outline(box(0.5, 0.5, 1, 1))), 0);
    EXPECT_NEAR(distance(outline(ring), outline(box(4, 4, 1, 1))), 2, 1e-12);
    EXPECT_EQ(distance(outline(box(-5, -5, 50, 50)), outline(ring)), 0);
}

// A point lies in a region or not, also where corners of the region are as high as the point.
TEST(Outline, ContainsThePointsOfItsArea) {
    Random random(5);
    int inside = 0;
    for (int trial = 0; trial < 300; ++trial) {
        polygon::Loops soup;
        for (int i = 0; i < 12; ++i) {
            const double x = std::floor(uniform(random, 0, 12)), y = std::floor(uniform(random, 0, 12));
            const double wide = std::ceil(uniform(random, 0, 5)), high = std::ceil(uniform(random, 0, 5));
            soup = trial % 2 == 0 || i % 3 > 0 ? polygon::unite(soup, box(x, y, wide, high))
                                               : polygon::subtract(soup, box(x, y, wide, high));
        }
        if (soup.empty()) continue;
        const polygon::Loops area = polygon::split(soup).part[0];
        const Outline whole = outline(area);
        for (int k = 0; k < 40; ++k) {
            const double x = std::floor(uniform(random, -1, 18)) + 0.5, y = std::floor(uniform(random, -1, 36)) / 2;
            const polygon::Loops dot = box(x, y, 0.01, 0.01);
            const bool on_edge = plain_distance(area, dot) == 0 && !polygon::contains(area, dot.points[0]);
            if (on_edge) continue; // a corner of the dot, or its side
            EXPECT_EQ(distance(whole, outline(dot)) == 0, polygon::contains(area, dot.points[0])) << x << " " << y;
            inside += polygon::contains(area, dot.points[0]) ? 1 : 0;
        }
    }
    EXPECT_GT(inside, 500);
}

// A ring in the hole of another one is not in its area. To find that out takes few edges of each.
TEST(Outline, LooksAtFewEdgesOfNestedRings) {
    const auto ring = [](double outer, std::size_t corners) {
        polygon::Loops out;
        for (const double sign : {1.0, -1.0}) {
            std::vector<geom::Vec2> loop;
            for (std::size_t k = 0; k < corners; ++k) {
                const double angle = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
                const double r = sign > 0 ? outer : outer - 1;
                loop.push_back({r * std::cos(angle), sign * r * std::sin(angle)});
            }
            out.add(loop);
        }
        return outline(std::move(out));
    };
    std::uint64_t few = 0, many = 0;
    EXPECT_FALSE(within(ring(10, 100), ring(8, 100), {0.01, 0, 0, false}, &few));
    EXPECT_FALSE(within(ring(10, 10000), ring(8, 10000), {0.01, 0, 0, false}, &many));
    EXPECT_LT(many, 1000U); // of 20,000 in each ring
    EXPECT_LT(many, 4 * few);
}

} // namespace
} // namespace filum::sequence
