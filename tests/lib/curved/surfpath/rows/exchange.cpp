// Loops become part of what lies beside them: nothing crosses, nothing is lost, and little is wasted.
#include "surfpath/rows/exchange.hpp"

#include "geom/segment.hpp"
#include "surface/curve/locate.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/plan/coverage.hpp"

#include "../../../shapes/surface/grid.hpp"
#include "../../../trials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace filum::surfpath {

using namespace rows;
using namespace plan;
namespace {

Surface sheet_to_join_on() {
    Notes notes;
    return surface::connect(surface::flat_grid(40, 40, 50, 50), notes);
}

Line through(const Surface& s, const std::vector<geom::Vec2>& points, bool closed) {
    const surface::curve::Locator locator(s);
    Line out{{}, closed};
    for (const auto& p : points) out.places.push_back(locator.nearest({p.x, p.y, 0}));
    return surface::curve::threaded(s, out);
}

// A long hole: two straight sides a spacing apart, `long` mm, and half circles; from (x, y) on, along `heading`.
Line pill(const Surface& s, geom::Vec2 at, double length, double heading) {
    const geom::Vec2 u{std::cos(heading), std::sin(heading)}, v{-u.y, u.x};
    std::vector<geom::Vec2> points;
    for (int i = 0; i <= 12; ++i) {
        const double a = -std::numbers::pi / 2 + std::numbers::pi * i / 12;
        points.push_back(at + (length + 0.5 * std::cos(a)) * u + (0.5 * std::sin(a)) * v);
    }
    for (int i = 0; i <= 12; ++i) {
        const double a = std::numbers::pi / 2 + std::numbers::pi * i / 12;
        points.push_back(at + (0.5 * std::cos(a)) * u + (0.5 * std::sin(a)) * v);
    }
    return through(s, points, true);
}

Line circle(const Surface& s, geom::Vec2 middle, double radius) {
    std::vector<geom::Vec2> points;
    const int n = static_cast<int>(20 * radius);
    for (int i = 0; i < n; ++i) {
        const double a = 2 * std::numbers::pi * i / n;
        points.push_back({middle.x + radius * std::cos(a), middle.y + radius * std::sin(a)});
    }
    return through(s, points, true);
}

Line straight(const Surface& s, double y) { return through(s, {{1, y}, {39, y}}, false); }

double wasted(const Surface& s, const std::vector<Line>& lines) {
    Plan plan;
    for (Line l : lines) {
        if (l.size() == 0) continue;
        if (l.closed) l.places.push_back(l.places[0]);
        l.closed = false;
        plan.strokes.push_back({{{std::move(l), false}}});
    }
    const Coverage c = cover(s, plan, 1);
    return c.voids() + c.overlap();
}

std::size_t whole(const std::vector<Line>& lines) {
    return static_cast<std::size_t>(
        std::count_if(lines.begin(), lines.end(), [](const Line& l) { return l.size() > 0; }));
}

std::size_t crossings(const std::vector<Line>& lines) {
    std::vector<geom::Vec2> a, b;
    for (const Line& l : lines)
        for (std::size_t i = 0; i + (l.closed ? 0 : 1) < l.size(); ++i) {
            const Vec3 p = l[i], q = l[(i + 1) % l.size()];
            a.push_back({p.x, p.y});
            b.push_back({q.x, q.y});
        }
    std::size_t out = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = i + 2; k < a.size(); ++k) out += geom::cross_properly(a[i], b[i], a[k], b[k]) ? 1 : 0;
    return out;
}

// Side by side: two half turns that face each other. Half of them is as good as the best.
TEST(Exchange, ALoopBesideALineBecomesPartOfIt) {
    const Surface s = sheet_to_join_on();
    for (const bool reversed : {false, true}) {
        std::vector<Line> lines{straight(s, 10), circle(s, {20, 21}, 10)};
        if (reversed) surface::curve::reverse(lines[0]);
        const Vec3 first = lines[0][0], last = lines[0].places.back().point;
        const double before = wasted(s, lines);
        const ExchangeResult made = exchange_loops(s, lines, std::vector<char>{0, 0}, {1, 4});
        EXPECT_EQ(made.count, 1U);
        ASSERT_EQ(lines[1].size(), 0U);
        EXPECT_FALSE(lines[0].closed);
        EXPECT_EQ(distance(lines[0][0], first), 0);
        EXPECT_EQ(distance(lines[0].places.back().point, last), 0);
        EXPECT_EQ(crossings(lines), 0U);
        EXPECT_NEAR(wasted(s, lines) - before, made.waste, 0.1);
        EXPECT_LT(made.waste, 0.8);
    }
}

// A tip that points at a line, and two that point at each other, are better places than any beside straight sides.
TEST(Exchange, TipsAreOpenedFirst) {
    const Surface s = sheet_to_join_on();
    std::vector<Line> at_line{straight(s, 10), pill(s, {20, 11.5}, 20, std::numbers::pi / 2)};
    const double before = wasted(s, at_line);
    const ExchangeResult one = exchange_loops(s, at_line, std::vector<char>{0, 0}, {1, 4});
    EXPECT_EQ(one.count, 1U);
    EXPECT_LT(one.waste, 0.3);
    EXPECT_NEAR(wasted(s, at_line) - before, one.waste, 0.1);
    std::vector<Line> tips{pill(s, {5, 20}, 10, 0), pill(s, {17, 20}, 10, 0)};
    const ExchangeResult two = exchange_loops(s, tips, std::vector<char>{0, 0}, {1, 4});
    EXPECT_EQ(two.count, 1U);
    EXPECT_LT(two.waste, -0.3);
    EXPECT_EQ(whole(tips), 1U);
    EXPECT_TRUE(tips[0].closed);
}

// Where tight turns count, two half turns cost more than a pair of crossing shifts, which keep the radius; and tips
// that point at each other, whose half turns vanish, gain more.
TEST(Exchange, TightTurnsCountAsWaste) {
    const Surface s = sheet_to_join_on();
    std::mt19937 random(11);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int trial = 0; trial < trials(10); ++trial) {
        const double r = 4 + 8 * unit();
        const geom::Vec2 middle{15 + 10 * unit(), 15 + 10 * unit()};
        const std::vector<Line> rings{circle(s, middle, r), circle(s, middle, r - 1)};
        auto lines = rings;
        EXPECT_EQ(exchange_loops(s, lines, std::vector<char>{0, 0}, {1, 4, 2.4}).count, 0U) << r;
        EXPECT_EQ(exchange_loops(s, lines, std::vector<char>{0, 0}, {1, 4}).count, 1U) << r;
        const double heading = 2 * std::numbers::pi * unit(), length = 4 + 4 * unit();
        const geom::Vec2 along{std::cos(heading), std::sin(heading)};
        const std::vector<Line> pills{pill(s, middle, length, heading),
                                      pill(s, middle - (length + 2) * along, length, heading)};
        auto counted = pills, not_counted = pills;
        const ExchangeResult with = exchange_loops(s, counted, std::vector<char>{0, 0}, {1, 4, 2.4}),
                             without = exchange_loops(s, not_counted, std::vector<char>{0, 0}, {1, 4});
        EXPECT_EQ(with.count, 1U);
        EXPECT_EQ(without.count, 1U);
        EXPECT_LT(with.waste, without.waste - 2) << heading;
        EXPECT_EQ(crossings(counted), 0U);
    }
}

// What is to be kept takes in others, but is not taken in; two open lines stay two.
TEST(Exchange, WhatIsKeptStaysApart) {
    const Surface s = sheet_to_join_on();
    std::vector<Line> lines{circle(s, {20, 20}, 10), circle(s, {20, 20}, 9), circle(s, {20, 20}, 8)};
    EXPECT_EQ(exchange_loops(s, lines, std::vector<char>{1, 0, 1}, {1, 4}).count, 1U);
    EXPECT_EQ(whole(lines), 2U);
    lines = {Line{}, straight(s, 9), circle(s, {20, 20}, 10)}; // what was taken in before is no line
    EXPECT_EQ(exchange_loops(s, lines, std::vector<char>{0, 0, 0}, {1, 4}).count, 1U);
    EXPECT_EQ(whole(lines), 1U);
    lines = {straight(s, 10), straight(s, 11)};
    EXPECT_EQ(exchange_loops(s, lines, std::vector<char>{0, 0}, {1, 4}).count, 0U);
    EXPECT_EQ(whole(lines), 2U);
}

// Rings about random middles, as deep as there is room, with a line below: one line comes of it, without a crossing.
TEST(Exchange, RingsAtRandomBecomeOne) {
    const Surface s = sheet_to_join_on();
    std::mt19937 random(7);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    for (int trial = 0; trial < trials(10); ++trial) {
        const double r = 4 + std::floor(7 * unit());
        const geom::Vec2 middle{13 + 14 * unit(), 6 + r};
        std::vector<Line> lines{straight(s, 5)};
        for (double now = r; now >= 2; now -= 1) lines.push_back(circle(s, middle, now));
        double length = 0;
        for (const Line& l : lines) length += surface::curve::length(l);
        const std::size_t loops = lines.size() - 1;
        const ExchangeResult made = exchange_loops(s, lines, std::vector<char>(lines.size(), 0), {1, 4});
        EXPECT_EQ(made.count, loops);
        EXPECT_EQ(whole(lines), 1U);
        EXPECT_EQ(crossings(lines), 0U);
        EXPECT_NEAR(surface::curve::length(lines[0]), length, 0.3 * static_cast<double>(loops));
        EXPECT_LT(made.waste, 0.9 * static_cast<double>(loops));
    }
}

} // namespace
} // namespace filum::surfpath
