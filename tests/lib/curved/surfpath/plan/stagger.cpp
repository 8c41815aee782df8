// Turns behind each other: their overlap at rims, against that of turns that all lie at the rim.
#include "surfpath/plan/stagger.hpp"

#include "surface/curve/walk.hpp"
#include "surfpath/plan/coverage.hpp"
#include "surfpath/rows/boustrophedon.hpp"

#include "../../../shapes/surface/grid.hpp"
#include "../../../trials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace filum::surfpath {

using namespace plan;
using namespace rows;
namespace {

using Bending = Vec3 (*)(Vec2);

Vec3 unbent(Vec2 p) { return {p.x, p.y, 0}; }
Vec3 leaning(Vec2 p) { return {0.6 * p.x - 0.224 * p.y, 0.8 * p.x + 0.168 * p.y, 0.96 * p.y}; }
Vec3 slanted(Vec2 p) { return {p.x + 0.5 * p.y, p.y, 0}; }
Vec3 sheared(Vec2 p) { return {p.x + p.y, p.y, 0}; } // rims at 45 degrees to lines along x
Vec3 rolled(Vec2 p) { return {p.x, 12 * std::sin(p.y / 12), 12 * std::cos(p.y / 12)}; }

// The rectangle [0, a] x [0, b] in cells of about 1 mm, put into space.
Surface sheet_of(double a, double b, Bending lift = unbent) {
    Notes notes;
    const auto hole = [](Vec2) { return false; };
    return surface::connect(surface::pierced_grid(a, b, static_cast<int>(a), static_cast<int>(b), lift, hole), notes);
}

// A line on the plate across at the height `y`, between two places.
Stroke stroke_across(const Surface& s, double y, double from, double to) {
    const auto at = [&](double x) {
        for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
            if (surface::curve::lies_in(s, t, {x, y, 0})) return Place{t, {x, y, 0}};
        ADD_FAILURE() << x << ' ' << y;
        return Place{};
    };
    return {{{surface::curve::join(s, at(from), at(to)), false}}};
}

TEST(Stagger, WhatOnlyOneWayCoversCountsTwiceAgainstItsLength) {
    const Surface s = sheet_of(20, 10);
    // The first way is 10 mm longer: 10 mm2 more, and it covers 10 mm2 that the second one does not.
    const std::vector<TurnVariants> turn{{stroke_across(s, 5.3, 2.3, 17.3), stroke_across(s, 5.3, 2.3, 7.3)}};
    EXPECT_EQ(staggered(s, {}, turn, 1), std::vector<std::uint32_t>{0});
    Plan below; // covers all of that
    below.strokes = {stroke_across(s, 5.3, 1.2, 18.7)};
    EXPECT_EQ(staggered(s, below, turn, 1), std::vector<std::uint32_t>{1});
    // Two turns that could both cover it: one does.
    EXPECT_EQ(staggered(s, {}, std::vector<TurnVariants>{turn[0], turn[0]}, 1), (std::vector<std::uint32_t>{1, 0}));
    EXPECT_TRUE(staggered(s, below, {}, 1).empty());
}

// Lines along x, `spacing` apart, from rim to rim.
std::vector<UnclippedLine> rim_to_rim(const Surface& s, double a, double b, double spacing, Bending lift) {
    std::vector<UnclippedLine> out;
    for (double y = spacing / 2; y < b - 0.4 * spacing; y += spacing) {
        Line line;
        for (int i = 0; i <= 24; ++i) {
            const Vec3 p = lift({a * (0.0005 + 0.999 * i / 24), y});
            const auto from = line.size() > 0 ? line.places.back().triangle : 0;
            std::uint32_t best = from;
            double least = 1e300;
            for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
                if (distance(p, s.vertices[s.triangles[t][0]]) > 2.5) continue;
                const Vec3 n = surface::normal(s, t);
                const Vec3 q = p + dot(s.vertices[s.triangles[t][0]] - p, n) * n; // a rolled plate has flat triangles
                if (distance(p, q) < least && surface::curve::lies_in(s, t, q)) {
                    least = distance(p, q);
                    best = t;
                }
            }
            const Vec3 n = surface::normal(s, best);
            line.places.push_back({best, p + dot(s.vertices[s.triangles[best][0]] - p, n) * n});
        }
        out.push_back({surface::curve::threaded(s, line), y});
    }
    return out;
}

TEST(Stagger, TurnsBehindEachOtherLayLessTwiceThanAllAtTheRim) {
    FILUM_NOT_SANITIZED();
    std::mt19937 random(7);
    const auto between = [&](double a, double b) { return a + (b - a) * static_cast<double>(random()) / 4294967296.0; };
    double staggered = 0, piled = 0; // overlap, mm2
    for (const Bending lift : {leaning, slanted, rolled}) {
        const double a = std::floor(between(14, 18)), b = std::floor(between(14, 18)), spacing = between(0.8, 1.2);
        const double radius = between(1.6, 2.8);
        const Surface s = sheet_of(a, b, lift);
        TurnOptions turns = turn_options(spacing, radius);
        const Rows all =
            rows::rows(s, rim_to_rim(s, a, b, spacing, lift), {spacing / 2, 2 * radius, radius, spacing / 4});
        const Plan plan = boustrophedon(s, all, turns);
        turns.staggered = false;
        const Plan at_rim = boustrophedon(s, all, turns);
        ASSERT_EQ(plan.strokes.size(), at_rim.strokes.size());
        const Coverage c = cover(s, plan, spacing), d = cover(s, at_rim, spacing);
        EXPECT_LE(c.overlap(), d.overlap()) << spacing << ' ' << radius;
        EXPECT_LT(c.voids() + c.overlap(), d.voids() + d.overlap()) << spacing << ' ' << radius;
        staggered += c.overlap();
        piled += d.overlap();
    }
    EXPECT_LT(staggered, 0.9 * piled);
}

// docs/algorithms/rows.md, "How little turns can waste": found by a search over all pairs and depths.
TEST(Stagger, TurnsWasteLittleMoreThanTheBestKnownOnes) {
    FILUM_NOT_SANITIZED();
    constexpr double kEnds = 60,
                     kCorner = 1.3; // mm2: the part of a corner of the plate that no arc of 2.4 reaches
    struct Rim {
        Bending lift;
        double best; // mm2 bare and twice per end of a row, of turns between every fifth row
    };
    for (const auto& [lift, best] : {Rim{unbent, 1.61}, Rim{sheared, 2.79}}) {
        const Surface s = sheet_of(24, kEnds / 2, lift);
        const Rows all = rows::rows(s, rim_to_rim(s, 24, kEnds / 2, 1, lift), {0.5, 4.8, 2.4, 0.25});
        const Plan plan = boustrophedon(s, all, turn_options(1, 2.4));
        ASSERT_EQ(plan.strokes.size(), 1u);
        const Coverage c = cover(s, plan, 1);
        const double wasted = (c.voids() + c.overlap() - 4 * kCorner) / kEnds;
        EXPECT_LT(wasted, 1.05 * best);
    }
}

} // namespace
} // namespace filum::surfpath
