// No tighter turns than asked for, and an honest account of those that are.
#include "fill/least_radius.hpp"
#include "fill/join/crossings.hpp"
#include "fill/rings/lanes.hpp"
#include "fill/spiral.hpp"
#include "pattern_check.hpp"
#include "toolpath/radius.hpp"

#include <gtest/gtest.h>

namespace filum::fill {

using namespace join;

namespace {

using geom::Vec2;
using polygon::Loops;
using test::disc;
using test::kWidth;
using test::random_region;
using test::rectangle;
using toolpath::Curve;

const Note* find(const Notes& notes, const std::string& what) {
    for (const Note& n : notes)
        if (code_name(n) == what) return &n;
    return nullptr;
}

Curve circle(double radius, int n) {
    const Loops outline = disc({3, 4}, radius, n);
    return {true, {outline[0].begin(), outline[0].end()}, {kWidth}};
}

TEST(LeastRadius, OfACircleIsItsRadius) {
    const Curve c = circle(2, 400);
    for (std::size_t i = 0; i < c.points.size(); ++i) EXPECT_NEAR(toolpath::radius_at(c.points, true, i, 0.2), 2, 0.02);
    EXPECT_EQ(tight_turns({c}, 0.2, 1.9).count, 0U);
    EXPECT_EQ(tight_turns({c}, 0.2, 2.1).count, 1U); // one long place
}

TEST(LeastRadius, OfASquareIsThatOfItsCorners) {
    const Curve c{true, {{0, 0}, {5, 0}, {5, 5}, {0, 5}}, {kWidth}};
    EXPECT_NEAR(toolpath::radius_at(c.points, true, 1, 0.2), 0.2 / std::sqrt(2.0), 1e-12);
    EXPECT_EQ(tight_turns({c}, 0.2, 0.2).count, 4U);
    EXPECT_EQ(tight_turns({c}, 0.2, 0.1).count, 0U);
}

TEST(LeastRadius, RingsKeepTheirDistanceAndLoseTheirCorners) {
    Note open;
    const rings::Rings lanes = rings::lanes(rectangle(0, 0, 10, 10), {.width = kWidth, .tolerance = 0.0005});
    const auto round = rings::curves_of(with_round_corners(lanes, kWidth, 0.0005, 1, open));
    EXPECT_GE(round.size(), 10U);
    for (std::size_t r = 0; r + 4 < round.size(); ++r) {
        EXPECT_EQ(tight_turns({round[r]}, 0.2, 0.95).count, 0U) << r;
        EXPECT_NEAR(polygon::bounds(round[r].points).lo.x, (static_cast<double>(r) + 0.5) * kWidth, 0.02);
        for (const double w : round[r].width) EXPECT_NEAR(w, kWidth, 0.1 * kWidth);
    }
    EXPECT_GT(open.amount, kWidth * (8 - 2 * 3.15)); // the outer ring's four corners alone
}

class RoundRegion : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RoundRegion, EveryTighterTurnIsCounted) {
    const Loops region = random_region(GetParam());
    for (const double radius : {0.2, 0.4, 1.0}) {
        Notes notes;
        const Spiral s = spiral(region, {.bead_width = kWidth, .min_radius = radius}, notes);
        ASSERT_EQ(s.curves.size(), 1U);
        EXPECT_EQ(crossing_pairs(s.curves, kWidth).size(), 0U);
        // places of tighter vertices, a bead width of path apart
        const auto& p = s.curves[0].points;
        std::size_t places = 0;
        double since = 1e9;
        for (std::size_t i = 0; i < p.size(); ++i) {
            since += i > 0 ? geom::distance(p[i - 1], p[i]) : 0;
            if (toolpath::radius_at(s.curves[0].points, true, i, kWidth / 2) >= radius) continue;
            places += since > kWidth ? 1 : 0;
            since = 0;
        }
        const Note* tight = find(notes, "turn-too-tight");
        EXPECT_EQ(tight == nullptr ? 0 : tight->count, places);
        // a note reports the open area: with the area under beads it makes up the region, roughly
        const Note* open = find(notes, "area-left-for-radius");
        const double area = polygon::signed_area(region), left = open == nullptr ? 0 : open->amount;
        EXPECT_LE(left, s.unplaced);
        EXPECT_GT(test::coverage(region, s.curves) + left / area, 0.9) << radius;
    }
}

INSTANTIATE_TEST_SUITE_P(LeastRadius, RoundRegion, testing::Range(1U, 12U));

TEST(LeastRadius, OnlyTurnsOfTheSpiralStayTightInABar) {
    const Loops bar = rectangle(0, 0, 40, 16);
    Notes notes, none;
    const Spiral s = spiral(bar, {.bead_width = kWidth, .min_radius = 0.4}, notes);
    const Spiral usual = spiral(bar, {.bead_width = kWidth}, none);
    EXPECT_LE(find(notes, "turn-too-tight")->count, 25U);
    EXPECT_GT(tight_turns(usual.curves, kWidth / 2, 0.4).count, 80U); // every corner of every ring
    EXPECT_EQ(find(none, "turn-too-tight"), nullptr);
    const auto& c = s.curves[0];
    for (std::size_t i = 0; i < c.points.size(); ++i) { // the corners of the outer rings
        const Vec2 p = c.points[i];
        if (std::min(p.x, 40 - p.x) < 2 && std::min(p.y, 16 - p.y) < 2) {
            EXPECT_GE(toolpath::radius_at(c.points, true, i, kWidth / 2), 0.4) << p.x << ',' << p.y;
        }
    }
}

} // namespace
} // namespace filum::fill
