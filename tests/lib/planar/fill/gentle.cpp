// Few sharp turns: double spirals, rounded corners, widened turns.
#include "fill/finish.hpp"
#include "fill/join/crossings.hpp"
#include "fill/join/cycle.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/rounding.hpp"
#include "fill/spiral.hpp"
#include "pattern_check.hpp"
#include "toolpath/grid.hpp"

#include <gtest/gtest.h>

namespace filum::fill {

using namespace join;

namespace {

using test::disc;
using test::kWidth;
using test::laid;
using test::length_of;
using test::random_region;
using test::rectangle;
using toolpath::Curve;

double anywhere(Vec2, double most) { return most; } // no outline near

rings::Rings lanes(const Loops& region) { return rings::lanes(region, {.width = kWidth, .tolerance = 0.005}); }

// Places where a closed line turns back: its ends 1.2 widths before and after are nearer than 1.15 widths, and it is
// the nearest such place for two widths around.
int turns_back(const std::vector<Vec2>& points) {
    std::vector<Vec2> even; // every twentieth of a width
    const double step = kWidth / 20;
    double left = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 a = points[i], b = points[(i + 1) % points.size()];
        const double l = geom::distance(a, b);
        for (; left < l; left += step) even.push_back(geom::lerp(a, b, left / l));
        left -= l;
    }
    const std::size_t n = even.size();
    int turns = 0, since = 1000;
    for (std::size_t i = 0; i < n; ++i, ++since) {
        if (geom::distance(even[(i + n - 24) % n], even[(i + 24) % n]) >= 1.15 * kWidth) continue;
        if (since > 40) ++turns;
        since = 0;
    }
    return turns;
}

int turns_back(const Loops& region, bool spirals) {
    const auto lines = join_rings(lanes(region), kWidth, region, spirals);
    EXPECT_EQ(lines.size(), 1U);
    return turns_back(lines[0].points);
}

TEST(DoubleSpiral, TurnsBackTwiceInARingShapedRegion) { // no ends of walls: only the turns of the one double spiral
    const Loops region = polygon::subtract(test::disc({0, 0}, 8, 200), test::disc({0, 0}, 3.2, 90));
    EXPECT_EQ(turns_back(region, true), 2);
    EXPECT_GT(turns_back(region, false), 15); // two per pair of rings
}

TEST(DoubleSpiral, LeavesFewTurnsWhereARegionDoesNotBranch) {
    // a spiral's two, and what the last rings and the ends of the middle need
    EXPECT_LE(turns_back(rectangle(0, 0, 100, 25), true), 4);
    EXPECT_LE(turns_back(rectangle(0, 0, 12, 12), true), 14); // the spiral does not always cross its middle
    EXPECT_LE(turns_back(test::disc({0, 0}, 9, 200), true), 6);
    EXPECT_GT(turns_back(rectangle(0, 0, 100, 25), false), 50);
}

TEST(DoubleSpiral, NeedsTurnsOnlyForBranchesAndEnds) {
    // four arms about a middle: four branches that end, a spiral for each and one for the middle
    const Loops cross = polygon::unite(rectangle(-15, -3, 15, 3.1), rectangle(-3.2, -15, 3, 15));
    EXPECT_LE(turns_back(cross, true), 4 * (4 + 1));
}

class Joined : public testing::TestWithParam<std::uint32_t> {};

// The first random region from this seed on whose inset by half a bead is one piece: the spiral joins no pieces.
Loops random_region_in_one_piece(std::uint32_t seed) {
    constexpr std::uint32_t kStep = 1000; // more than there are seeds, so that no two tests get the same region
    for (;; seed += kStep) {
        Loops region = random_region(seed);
        if (polygon::split(polygon::offset(region, -kWidth / 2)).part.size() == 1) return region;
    }
}

// Spirals join all rings that pairs of links can join; and no ring loses more than the bends take.
TEST_P(Joined, SpiralsKeepEveryRingInOneCurveThatDoesNotCrossItself) {
    const Loops region = random_region_in_one_piece(GetParam());
    const rings::Rings rings = lanes(region);
    const auto plain = join_rings(rings, kWidth, region, false);
    const auto wound = join_rings(rings, kWidth, region, true);
    EXPECT_EQ(wound.size(), plain.size());
    EXPECT_EQ(crossing_pairs(wound, kWidth).size(), 0U);
    std::vector<geom::Segment> segments;
    for (const auto& l : wound)
        for (std::size_t i = 0; i < l.points.size(); ++i)
            segments.push_back({l.points[i], l.points[(i + 1) % l.points.size()]});
    const geom::SegmentGrid grid(segments, kWidth);
    for (const Vec2 p : rings.points) {
        double best = 1e9;
        grid.near({p.x - kWidth, p.y - kWidth}, {p.x + kWidth, p.y + kWidth}, [&](std::uint32_t k) {
            best = std::min(best, geom::point_segment_distance(segments[k].a, segments[k].b, p));
        });
        EXPECT_LE(best, kWidth) << p.x << ',' << p.y;
    }
}

INSTANTIATE_TEST_SUITE_P(DoubleSpiral, Joined, testing::Range(100U, 140U));

Curve square(double side) {
    Curve out{true, {}, {}};
    for (const Vec2 p : {Vec2{0, 0}, Vec2{side, 0}, Vec2{side, side}, Vec2{0, side}}) out.add(p, kWidth);
    return out;
}

double sharpest(const std::vector<Vec2>& points) { // rad, at any vertex
    double most = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t n = points.size();
        const Vec2 u = points[(i + 1) % n] - points[i], v = points[(i + 2) % n] - points[(i + 1) % n];
        most = std::max(most, std::abs(std::atan2(geom::cross(u, v), geom::dot(u, v))));
    }
    return most;
}

constexpr Corners kCorners{.open = rings::kLeastVoid * kWidth * kWidth, .tolerance = 0.01};

double enclosed(const Curve& line) { return polygon::signed_area(std::span<const Vec2>(line.points)); }

TEST(Rounded, TurnsCornersIntoCurvesOfTheSameMaterial) {
    const Curve line = square(10), round = rounded(line, kWidth, kCorners, anywhere);
    EXPECT_LT(sharpest(round.points), 0.4);
    EXPECT_NEAR(laid({{true, round.points, round.width}}), laid({{true, line.points, line.width}}), 1e-2);
    EXPECT_LT(length_of({true, round.points, round.width}), 40 - 4 * 0.1 * kWidth);
    for (const double open : {kCorners.open, kCorners.open / 3}) // beyond each right angle
        EXPECT_NEAR(enclosed(line) - enclosed(rounded(line, kWidth, {open, 1e-5}, anywhere)), 4 * open, 0.02 * open);
}

// Where a closed line begins has no influence: just before a corner the last rounded stretch holds the first point.
TEST(Rounded, DoesNotDependOnTheBegin) {
    Curve line{true, {}, {}};
    const Curve corners = square(3);
    for (std::size_t i = 0; i < 4; ++i)
        for (int k = 0; k < 40; ++k)
            line.add(geom::lerp(corners.points[i], corners.points[(i + 1) % 4], k / 40.0), kWidth);
    const Curve round = rounded(line, kWidth, kCorners, anywhere);
    for (std::size_t k = 0; k < line.points.size(); ++k) {
        std::rotate(line.points.begin(), line.points.begin() + 1, line.points.end());
        const Curve again = rounded(line, kWidth, kCorners, anywhere);
        EXPECT_NEAR(length_of({true, again.points, again.width}), length_of({true, round.points, round.width}), 1e-2)
            << k;
        EXPECT_NEAR(enclosed(again), enclosed(round), 1e-3) << k;
        EXPECT_TRUE(toolpath::crossing_pairs({again}, kWidth).empty()) << k;
    }
}

// Corners far from each other cost a machine little time, so they stay one point.
TEST(Rounded, KeepsCornersThatAreRare) {
    Corners how = kCorners;
    how.rare = 12; // mm for each right angle
    EXPECT_EQ(rounded(square(11), kWidth, how, anywhere).points.size(),
              rounded(square(11), kWidth, kCorners, anywhere).points.size());
    EXPECT_EQ(rounded(square(13), kWidth, how, anywhere).points, square(13).points);
}

TEST(Rounded, LeavesNoMoreThanAskedForInAll) {
    Curve saw; // forty right angles
    for (int k = 0; k < 20; ++k) {
        saw.add({2.0 * k, 0}, kWidth);
        saw.add({2.0 * k + 1, 1}, kWidth);
    }
    saw.add({40, 0}, kWidth);
    saw.add({40, 5}, kWidth);
    saw.add({0, 5}, kWidth);
    const auto off = [&](const Corners& how) { // between the lines
        double out = 0;
        const Curve round = rounded(saw, kWidth, how, anywhere);
        polygon::Loops a, b;
        a.add(saw.points), b.add(round.points);
        for (const auto& [p, q] : {std::pair{&a, &b}, std::pair{&b, &a}})
            out += polygon::signed_area(polygon::subtract(*p, *q));
        return out;
    };
    Corners how = kCorners;
    EXPECT_GT(off(how), 38 * how.open);
    how.open_in_all = 10 * how.open;
    EXPECT_LT(off(how), 1.1 * how.open_in_all);
    EXPECT_GT(off(how), 0.8 * how.open_in_all);
}

TEST(Rounded, LeavesGentleCornersAndMovesThoseOfTheOutlineNoFurtherThanABeadMayBeOff) {
    const auto at_outline = [](Vec2, double most) { return std::min(most, kWidth / 2); };
    for (double turn = 0.05; turn < 3; turn += 0.1) { // rad, at the middle of the upper side
        const Vec2 tip{5, 10 + 5 * std::tan(turn / 2)};
        Curve line;
        for (const Vec2 p : {Vec2{0, 0}, Vec2{10, 0}, Vec2{10, 10}, tip, Vec2{0, 10}}) line.add(p, kWidth);
        const auto moved = [&](const Curve& round) {
            double best = 1e9;
            for (std::size_t i = 0; i < round.points.size(); ++i)
                best = std::min(best, geom::point_segment_distance(round.points[i],
                                                                   round.points[(i + 1) % round.points.size()], tip));
            return best;
        };
        const Corners fine{kCorners.open, 1e-5};
        const double inside = moved(rounded(line, kWidth, fine, anywhere));
        const double outside = moved(rounded(line, kWidth, fine, at_outline));
        EXPECT_TRUE(inside < 1e-9 || inside > kWidth / 16 - 1e-3) << turn;
        EXPECT_LE(outside, kWidth / 8 + 1e-4) << turn;
        EXPECT_NEAR(outside, std::min(inside, kWidth / 8), 1e-4) << turn;
        EXPECT_EQ(inside > 1e-9, std::sin(turn / 2) * std::sqrt(6 * kCorners.open) / 2 >= kWidth / 16) << turn;
        const Corners inner{kCorners.open, kCorners.tolerance, Rounded::inside};
        EXPECT_LT(moved(rounded(line, kWidth, inner, at_outline)), 1e-9) << turn;
    }
}

TEST(Rounded, KeepsBeadsInsideTheOutline) {
    const auto room = [](Vec2 p, double most) {
        return std::min(most, std::min({p.x, p.y, 10 - p.x, 10 - p.y}) + kWidth / 2);
    };
    const Curve round = rounded(square(10), kWidth, kCorners, room);
    for (std::size_t i = 0; i < round.points.size(); ++i)
        EXPECT_LE(round.width[i] / 2, room(round.points[i], 10) + 0.02 * kWidth);
}

// Lines with two ends take in the rings beside them, and never each other.
TEST(JoinRings, LeavesOpenLinesOpen) {
    const double w = kWidth;
    rings::Rings lines;
    for (const double y : {0.0, w}) lines.add({false, {{0, y}, {4, y}, {10, y}}, {w, w, w}}, 0);
    const Loops outer = rectangle(-w, -w, 10 + w, 2 * w);
    Curve ring{true, {outer[0].begin(), outer[0].end()}, std::vector<double>(outer[0].size(), w)};
    lines.add(ring, 1);
    const auto out = join_rings(lines, w);
    ASSERT_EQ(out.size(), 2U);
    for (const std::size_t k : {0U, 1U}) {
        EXPECT_FALSE(out[k].closed);
        EXPECT_EQ(out[k].points.front(), lines.points[3 * k]);
        EXPECT_EQ(out[k].points.back(), lines.points[3 * k + 2]);
    }
    EXPECT_EQ(crossing_pairs(out, w).size(), 0U);
    EXPECT_NEAR(laid(out), w * (2 * 10 + 2 * (10 + 2 * w + 3 * w)), w * w / 4);
}

TEST(Rounded, StartsAnywhereOnTheLine) { // the first point may be a corner or not
    Curve shifted = square(10);
    shifted.points.insert(shifted.points.begin(), {5, 0});
    shifted.width.push_back(kWidth);
    shifted.points.erase(shifted.points.begin() + 1);
    shifted.points.push_back({0, 0});
    const double a = length_of({true, rounded(shifted, kWidth, kCorners, anywhere).points, {kWidth}});
    const double b = length_of({true, rounded(square(10), kWidth, kCorners, anywhere).points, {kWidth}});
    EXPECT_NEAR(a, b, 1e-9);
}

TEST(Rounded, LeavesStraightLinesAndSpecksAlone) {
    EXPECT_EQ(rounded(square(0.4), kWidth, kCorners, anywhere).points, square(0.4).points);
    Curve circle;
    const Loops outline = disc({0, 0}, 5, 200);
    for (const Vec2 p : outline[0]) circle.add(p, kWidth);
    EXPECT_EQ(rounded(circle, kWidth, kCorners, anywhere).points, circle.points);
}

TEST(Rounded, KeepsCornersAlongTheOutlineWhereAsked) {
    const Corners inside{kCorners.open, kCorners.tolerance, Rounded::inside};
    const auto room = [](Vec2 p, double most) {
        return std::min(most, std::min({p.x, p.y, 10 - p.x, 10 - p.y}) + kWidth / 2);
    };
    EXPECT_EQ(rounded(square(10), kWidth, inside, room).points, square(10).points);
    EXPECT_LT(sharpest(rounded(square(10), kWidth, inside, anywhere).points), 0.4); // an inner bead
}

} // namespace
} // namespace filum::fill
