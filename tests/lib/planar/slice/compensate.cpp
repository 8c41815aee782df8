#include "slice/compensate.hpp"
#include "polygon/clip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace filum;
using polygon::Loops;

Loops square(double side) {
    Loops out;
    out.add(std::vector<geom::Vec2>{{0, 0}, {side, 0}, {side, side}, {0, side}});
    return out;
}

Loops ring(double x, double y, double radius, bool hole) {
    std::vector<geom::Vec2> points;
    constexpr int n = 720;
    for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * (hole ? n - k : k) / n;
        points.push_back({x + radius * std::cos(a), y + radius * std::sin(a)});
    }
    Loops out;
    out.add(points);
    return out;
}

Loops with(Loops a, const Loops& b) {
    for (std::size_t i = 0; i < b.size(); ++i) a.add(b[i]);
    return a;
}

double disc(double radius) { return std::numbers::pi * radius * radius; }

TEST(Compensated, MovesOutlinesByWhatWasAsked) {
    // a plate with a hole, and a pin in the hole
    const Loops area = with(with(square(20), ring(10, 10, 5, true)), ring(10, 10, 2, false));
    const auto of = [&](const slice::Compensation& by, std::uint32_t layer) {
        Notes notes;
        const Loops out = slice::compensated(area, {}, by, layer, notes);
        EXPECT_TRUE(notes.empty());
        EXPECT_EQ(out.size(), 3U);
        return polygon::signed_area(out);
    };
    for (const double d : {0.1, 0.25, -0.1, -0.25}) {
        const double corners = d > 0 ? (4 - std::numbers::pi) * d * d : 0; // become round
        EXPECT_NEAR(of({0, d, 0}, 7), std::pow(20 + 2 * d, 2) - corners - disc(5 - d) + disc(2 + d), 0.05) << d;
        EXPECT_NEAR(of({0, 0, d}, 7), 400 - disc(5 + d) + disc(2), 0.05) << d;
    }
    EXPECT_NEAR(of({0.2, 0, 0}, 0), std::pow(19.6, 2) - disc(5.2) + disc(1.8), 0.05);
    EXPECT_NEAR(of({0.2, 0, 0}, 1), 400 - disc(5) + disc(2), 0.05); // of the first layer only
}

TEST(Compensated, ThinWallsKeepStandingOnTheFirstLayer) {
    // a plate with a fin 0.5 mm wide and 10 mm long
    Loops fin;
    fin.add(std::vector<geom::Vec2>{{19, 9}, {30, 9}, {30, 9.5}, {19, 9.5}});
    const Loops area = polygon::unite(square(20), fin);
    Notes notes;
    const Loops out = slice::compensated(area, {}, {0.2, 0, 0}, 0, notes);
    EXPECT_EQ(out.size(), 1U); // in one piece
    EXPECT_NEAR(polygon::bounds(out).hi.x, 30, 1e-3);
    EXPECT_NEAR(polygon::bounds(out).lo.x, 0.2, 1e-3);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NEAR(notes[0].amount, 5, 0.5);
}

TEST(Compensated, WhatVanishesIsTold) {
    const Loops area = with(square(20), ring(40, 10, 0.2, false));
    Notes notes;
    const Loops out = slice::compensated(area, {}, {0, -0.3, 0}, 3, notes);
    EXPECT_EQ(out.size(), 1U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NEAR(notes[0].amount, disc(0.2), 1e-3);
    EXPECT_EQ(notes[0].layer, 3);
    EXPECT_NEAR(notes[0].x, 40, 1e-3);
}

} // namespace
