// Stretches of rings near others, against all places and all segments.
#include "fill/join/ring_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace filum::fill::join {
namespace {

// Long strips at an angle, with turns of many points, and some specks.
rings::Rings strips(std::mt19937& random) {
    std::uniform_real_distribution<double> some(0, 1);
    polygon::Loops loops;
    const double angle = 6 * some(random);
    const Vec2 u{std::cos(angle), std::sin(angle)}, v{-u.y, u.x};
    for (int k = 0; k < 8; ++k) {
        const double y = 3 * k + some(random), length = 20 + 30 * some(random), half = 0.2 + some(random);
        for (const double side : {-1.0, 1.0})
            for (int i = 0; i <= 6; ++i) {
                const double a = 3.14159 * (i / 6.0 - 0.5);
                loops.points.push_back(side * (length / 2 + half * std::cos(a)) * u +
                                       (y + side * half * std::sin(a)) * v);
            }
        loops.close();
    }
    for (int k = 0; k < 10; ++k) {
        const Vec2 at{40 * some(random) - 20, 24 * some(random)};
        loops.add(std::vector<Vec2>{at, at + Vec2{some(random), 0.1}, at + Vec2{0.2, 1}});
    }
    return {loops.points, std::vector(loops.points.size(), 0.4), loops.start, std::vector<int>(loops.size(), 1)};
}

TEST(RingGraph, StretchesNearOthersHoldAllPlacesThatAreNear) {
    std::mt19937 random(1);
    std::size_t near = 0, held = 0, all = 0;
    for (int round = 0; round < 20; ++round) {
        const rings::Rings rings = strips(random);
        const RingGraph graph(rings, 0.6);
        const double reach = 0.9;
        const auto stretches = graph.near_others(reach);
        for (std::uint32_t r = 0; r < graph.size(); ++r)
            for (double s = 0; s < graph.length(r); s += 0.05) {
                const Vec2 p = graph.at(r, s);
                const bool is_near =
                    graph.nearest(p, reach, [&](std::uint32_t other) { return other != r; }).has_value();
                bool is_held = false;
                for (const Stretch& t : stretches[r]) is_held = is_held || (t.from <= s && s <= t.to);
                EXPECT_TRUE(is_held || !is_near) << round << " ring " << r << " at " << s;
                near += is_near ? 1 : 0;
                held += is_held ? 1 : 0;
                ++all;
            }
    }
    EXPECT_GT(near, 1000U);
    EXPECT_LT(held, all / 2) << near;
}

} // namespace
} // namespace filum::fill::join
