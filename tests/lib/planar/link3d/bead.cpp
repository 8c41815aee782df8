#include "link3d/bead.hpp"
#include "../../trials.hpp"
#include "curves.hpp"
#include "link3d/strip_route.hpp"
#include "toolpath/grid.hpp"

#include <gtest/gtest.h>

namespace filum::link3d {

using namespace test;

namespace {

double area(const Bead& b) {
    double sum = 0;
    const auto w = [&](std::size_t i) { return b.width.size() == 1 ? b.width[0] : b.width[i]; };
    for (std::size_t i = 0; i + 1 < b.points.size(); ++i)
        sum += geom::distance(b.points[i], b.points[i + 1]) * (w(i) + w(i + 1)) / 2;
    return sum;
}

double perimeter(const Curve& c) { return length(c.points) + geom::distance(c.points.back(), c.points.front()); }

double clearance(const std::vector<Vec2>& way, const SegmentIndex& index) {
    double least = 1e300; // the first step begins on the curve
    for (std::size_t i = 1; i + 1 < way.size(); ++i)
        for (int k = 0; k <= 20; ++k)
            least = std::min(least, index.nearest(geom::lerp(way[i], way[i + 1], k / 20.0))->distance);
    return least;
}

int crossings(const std::vector<Vec2>& way, const std::vector<Vec2>& line) {
    int n = 0;
    for (std::size_t i = 0; i + 1 < way.size(); ++i)
        for (std::size_t j = 0; j + 1 < line.size(); ++j)
            n += geom::cross_properly(way[i], way[i + 1], line[j], line[j + 1]) ? 1 : 0;
    return n;
}

} // namespace

TEST(Bead, CutGoesOnceAroundAndStopsAGapShort) {
    Random random{3};
    for (const Curve& plain : {comb({1, 2}, 8, 10), rings({0, 0}, 3, 6), circle({0, 0}, 0.3, 12)}) {
        for (const Curve& c : {plain, refined(plain, 0.3, random)}) {
            const SegmentIndex index(std::span(&c, 1));
            for (int k = 0; k < 100; ++k) {
                const auto at = *index.nearest({10 * random() - 3, 8 * random() - 3});
                const bool against = k % 2 == 0;
                const double gap = cut_gap(c);
                const Bead b = cut(c, at, against, gap);
                EXPECT_EQ(b.points.front(), at.point);
                const double longer = perimeter(c) - gap - length(b.points); // the gap, where it ends at a corner
                EXPECT_TRUE(longer > -1e-5 && longer < kCorner) << longer;
                if (longer > 1e-5) {
                    EXPECT_EQ(std::count(c.points.begin(), c.points.end(), b.points.back()), 1);
                }
                EXPECT_TRUE(b.width.size() == 1 || b.width.size() == b.points.size());
                // every point is there, except those in the gap, in the order asked for
                std::size_t found = 0;
                for (const auto p : c.points)
                    for (const auto q : b.points) found += geom::distance(p, q) < 1e-5 ? 1 : 0;
                EXPECT_GE(found + 2, c.points.size());
                const Vec2 then = c.points[against ? at.segment : (at.segment + 1) % c.points.size()];
                EXPECT_LT(std::min(geom::distance(b.points[1], then), geom::distance(at.point, then)), 1e-5);
            }
        }
    }
}

// A piece too short for machine code would lie on the segment before it, and a jog from its end could cross that.
TEST(Bead, CutEndsAtACornerRatherThanJustBehindIt) {
    const Curve c{true, {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {0.5}};
    const auto end = [&](double gap) { return cut(c, Place{0, 0, 0.25, {1, 0}, 0}, false, gap).points.back(); };
    EXPECT_EQ(end(1 - 1e-5), (Vec2{0, 0}));
    EXPECT_EQ(end(1 - 0.9 * kCorner), (Vec2{0, 0}));
    EXPECT_LT(geom::distance(end(1 - 2 * kCorner), {2 * kCorner, 0}), 1e-9);
    EXPECT_LT(geom::distance(end(1 + 1e-3), {0, 1e-3}), 1e-9);
}

TEST(Bead, OpenCurveRunsBothWays) {
    const Curve c{false, {{0, 0}, {1, 0}, {1, 1}}, {0.4, 0.5, 0.6}};
    const Bead b = run(c, true);
    EXPECT_EQ(b.points, (std::vector<Vec2>{{1, 1}, {1, 0}, {0, 0}}));
    EXPECT_EQ(b.width, (std::vector{0.6, 0.5, 0.4}));
    EXPECT_EQ(run(c, false).points, c.points);
}

TEST(Bead, PinAddsAPointWithoutMovingTheLine) {
    Random random{4};
    const Curve c = refined(rings({0, 0}, 3, 6), 0.5, random);
    const SegmentIndex index(std::span(&c, 1));
    Bead b = run(c, false);
    const double before = area(b);
    const auto n = b.points.size();
    const auto at = *index.nearest({2.7, 1.13});
    pin(b, at.point, 0.001);
    EXPECT_EQ(b.points.size(), n + 1);
    EXPECT_EQ(b.width.size(), n + 1);
    EXPECT_NEAR(area(b), before, 1e-9);
    pin(b, {0.01, 0.02}, 0.001);
    pin(b, at.point, 0.001);
    EXPECT_EQ(b.points.size(), n + 1) << "it is there already";
}

// Beside a corner's outside the corner is the nearest place of both its segments: a point put into one of them would
// let a jog cross the other.
TEST(Bead, PinTakesTheCornerThatItIsBeside) {
    Bead b{{{0, 0}, {1, 0}, {1, 1}}, {kWidth}};
    const Vec2 p{1.01, -0.01};
    pin(b, p, 0.02);
    ASSERT_EQ(b.points.size(), 3U);
    EXPECT_EQ(b.points[1], p);
}

// From anywhere to anywhere: nothing is crossed, and what the lane lays comes out of its neighbours.
TEST(StripRoute, CrossesNothingAndKeepsTheVolume) {
    Random random{5};
    for (const Curve& plain : {comb({0, 0}, 9, 16), rings({4, 4}, 4, 10)}) {
        for (const Curve& c : {plain, refined(plain, 0.35, random)}) {
            const SegmentIndex closed(std::span(&c, 1));
            for (int k = 0; k < trials(12); ++k) {
                const auto at = *closed.nearest({8 * random(), 6 * random()});
                Bead bead = cut(c, at, k % 2 == 0, cut_gap(c));
                const Curve line{false, bead.points, {kWidth}};
                const SegmentIndex index(std::span(&line, 1));
                const Vec2 goal{1 + 6 * random(), 1 + 4 * random()};
                const auto way = strip_route(
                    std::span(&bead.points, 1), std::span(&line, 1), index, bead.points.back(), kWidth, kStrips, 1,
                    [&](Vec2 p, int) { return geom::distance(p, goal) < 1.5 * kWidth ? 1 : 0; });
                ASSERT_TRUE(way) << at.point.x << "," << at.point.y << " to " << goal.x << "," << goal.y << " case "
                                 << k << " n " << c.points.size();
                EXPECT_EQ(way->front(), bead.points.back());
                EXPECT_LT(geom::distance(way->back(), goal), 1.5 * kWidth);
                EXPECT_EQ(crossings(*way, bead.points), 0);
                EXPECT_GT(clearance(*way, index), 0.19 * kWidth);
                const double before = area(bead), lane = 0.5 * kWidth * length(*way);
                const double taken =
                    thin_beside(bead, *way, 0.5 * kWidth, kWidth, 0.5, SegmentCells(std::span(&line, 1)));
                EXPECT_NEAR(before - area(bead), taken, 1e-9);
                EXPECT_EQ(crossings(bead.points, bead.points), 0);
                EXPECT_EQ(crossings(*way, bead.points), 0);
                EXPECT_NEAR(taken, lane, 0.02 * lane + 0.1 * kWidth * kWidth);
                for (const double w : bead.width) EXPECT_GT(w, 0.4 * 0.9 * kWidth);
            }
        }
    }
}

// Two lanes one width apart and a lane between them: together they still fill the same two widths.
TEST(Bead, KeepsItsFarEdgeBesideALane) {
    Bead b{{{0, 0}, {10, 0}, {10, kWidth}, {0, kWidth}}, {kWidth}};
    const std::vector<Vec2> lane{{3, kWidth / 2}, {7, kWidth / 2}};
    const Curve line{false, b.points, {kWidth}};
    thin_beside(b, lane, kWidth / 2, kWidth, 0.5, SegmentCells(std::span(&line, 1)));
    int beside = 0;
    for (std::size_t i = 0; i < b.points.size(); ++i) {
        if (b.points[i].x < 3.4 || b.points[i].x > 6.6) continue;
        ++beside;
        const bool lower = b.points[i].y < kWidth / 2;
        EXPECT_NEAR(b.width[i], 0.75 * kWidth, 0.01 * kWidth);
        EXPECT_NEAR(b.points[i].y + (lower ? -1 : 1) * b.width[i] / 2, (lower ? -0.5 : 1.5) * kWidth, 1e-9);
    }
    EXPECT_GE(beside, 20);
    EXPECT_EQ(b.points.front(), (Vec2{0, 0}));
}

// Where a jog leaves the bead, the bead stays: moved past its beginning, it would cross the jog.
TEST(Bead, StaysWhereAJogLeavesIt) {
    for (const bool kept : {false, true}) {
        Bead b{{{0, 0}, {10, 0}, {10, kWidth}, {0, kWidth}}, {kWidth}};
        const Vec2 jog{5.03, 0};
        pin(b, jog, 0.02);
        const std::vector<Vec2> lane{{3, kWidth / 2}, {7, kWidth / 2}};
        const Curve line{false, b.points, {kWidth}};
        thin_beside(b, lane, kWidth / 2, kWidth, 0.5, SegmentCells(std::span(&line, 1)),
                    kept ? std::optional(jog) : std::nullopt);
        EXPECT_EQ(std::count(b.points.begin(), b.points.end(), jog), kept ? 1 : 0);
    }
}

// A point of a slender tip that moves aside would go through the tip's other side (a slice of a house).
TEST(Bead, TipsThatWouldCrossThemselvesStay) {
    Bead b{{{20.105, 0.708},
            {20.131, 0.6},
            {20.154, 0.568},
            {20.177, 0.549},
            {20.25, 0.472},
            {20.284, 0.449},
            {20.248, 0.469},
            {20.149, 0.508},
            {20.12, 0.524},
            {20.084, 0.537},
            {19.8, 0.6}},
           {.4007, .4007, .3727, .3407, .2634, .2237, .2634, .3407, .3727, .4007, .4}};
    const std::vector<Vec2> lane{
        {20.4863, 0.029}, {20.593, 0.1985}, {20.51, 0.2985}, {20.1243, 0.3055}, {20.0423, 0.3395}};
    const Curve line{false, b.points, b.width};
    ASSERT_TRUE(toolpath::crossing_pairs({line}, kWidth).empty());
    EXPECT_GT(thin_beside(b, lane, kWidth / 2, kWidth, 0.5, SegmentCells(std::span(&line, 1))), 0);
    EXPECT_TRUE(toolpath::crossing_pairs({{false, b.points, b.width}}, kWidth).empty());
}

TEST(StripRoute, TakesTheBestPlaceThenTheNearest) {
    const Curve c = comb({0, 0}, 9, 16);
    const SegmentIndex index(std::span(&c, 1));
    auto line = c.points;
    line.push_back(line.front());
    const Vec2 from = c.points[2];
    const auto to = [&](int best) {
        return strip_route(std::span(&line, 1), std::span(&c, 1), index, from, kWidth, kStrips, best, [](Vec2 p, int) {
            return p.y > 4 ? 2 : p.y > 1 ? 1 : 0;
        });
    };
    ASSERT_TRUE(to(1) && to(2));
    EXPECT_GT(to(1)->back().y, 1);
    EXPECT_LT(to(1)->back().y, 2);
    EXPECT_GT(to(2)->back().y, 4);
    EXPECT_LT(to(2)->back().y, 5);
}

TEST(StripRoute, KeepsOutOfHolesAndTheOutside) {
    const std::vector<std::vector<Vec2>> lines{{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}},
                                               {{2, 2}, {8, 2}, {8, 8}, {2, 8}, {2, 2}}};
    const std::vector<Curve> curves{{false, lines[0], {kWidth}}, {false, lines[1], {kWidth}}};
    const auto way = strip_route(lines, curves, SegmentIndex(curves), {0, 0}, kWidth, kStrips, 1,
                                 [](Vec2 p, int) { return p.x > 5 ? 1 : 0; });
    EXPECT_FALSE(way);
}

} // namespace filum::link3d
