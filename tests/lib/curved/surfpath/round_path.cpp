// Kinks of a path are rounded to half a spacing, bends to the least radius, and nothing else moves.
#include "surfpath/plan/round_path.hpp"

#include "base/mix.hpp"
#include "plate_lines.hpp"
#include "surface/curve/turns.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/plan/declare.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace filum::surfpath::kinks {

using namespace plan;

namespace {

using std::numbers::pi;

constexpr double kSpacing = 1;

// The polyline through points of the plate as a plan of one stroke.
Plan plan_through(const Surface& s, bool rolled, const std::vector<Vec2>& way) {
    return Plan{{Stroke{{Section{line_through(s, rolled, way), false}}}}, {}, {}, {}};
}

double kink_length(const Surface& s, const Plan& plan) {
    const auto normals = surface::curve::vertex_normals(s);
    double out = 0;
    for (const Stroke& stroke : plan.strokes) {
        std::vector<Vec3> points, up;
        for (const Section& section : stroke.sections)
            for (const Place& p : section.line.places) {
                points.push_back(p.point);
                up.push_back(surface::curve::normal_at(s, normals, p));
            }
        const double limit = surface::curve::kKinkRadius * kSpacing;
        const auto turns = surface::curve::tight_turns(points, up, limit, surface::curve::turn_reach(limit, kSpacing));
        out += surface::curve::length(turns);
    }
    return out;
}

// mm: the farthest that a place of `a` is from the line of `b`.
double apart(const Line& a, const Line& b) {
    double out = 0;
    for (const Place& p : a.places) {
        double least = 1e9;
        for (std::size_t i = 0; i + 1 < b.size(); ++i) {
            const Vec3 d = b[i + 1] - b[i];
            const double t = norm2(d) > 0 ? std::clamp(dot(p.point - b[i], d) / norm2(d), 0.0, 1.0) : 0;
            least = std::min(least, distance(p.point, b[i] + t * d));
        }
        out = std::max(out, least);
    }
    return out;
}

// The line keeps its ends, lies on the surface, and moved by less than `most` mm.
void expect_moved_within(const Surface& s, const Line& before, const Line& after, double most) {
    EXPECT_EQ(after[0], before[0]);
    EXPECT_LT(distance(after.places.back().point, before.places.back().point), 1e-9);
    EXPECT_LT(apart(after, before), most);
    for (const Place& p : after.places) EXPECT_TRUE(surface::curve::lies_in(s, p.triangle, p.point));
}

void expect_rounded(bool rolled, const std::vector<Vec2>& way) {
    const Surface s = plate(rolled);
    Plan plan = plan_through(s, rolled, way);
    const Line before = plan.strokes[0].sections[0].line;
    ASSERT_GT(kink_length(s, plan), 0);
    round_kinks(s, plan, kSpacing);
    ASSERT_EQ(plan.strokes.size(), 1U);
    EXPECT_EQ(kink_length(s, plan), 0);
    const Line& after = plan.strokes[0].sections[0].line;
    expect_moved_within(s, before, after, 0.51 * kSpacing);
}

TEST(Kinks, CornersOfAnyAngleBecomeArcs) {
    for (const bool rolled : {false, true})
        for (const double degrees : {40.0, 60.0, 90.0, 110.0, 130.0}) {
            const double a = degrees / 180 * pi;
            SCOPED_TRACE(degrees);
            expect_rounded(rolled, {{20, 20.3}, {30, 20.3}, {30 + 10 * std::cos(a), 20.3 + 10 * std::sin(a)}});
        }
}

// Tips between lines that are nearer than a spacing, as at births: bulbs. Those of two thirds of a spacing and less
// become wider, but not all the way.
TEST(Kinks, NarrowTipsBecomeBulbs) {
    for (const bool rolled : {false, true})
        for (const double gap : {0.75, 0.8, 0.85}) {
            std::vector<Vec2> way{{20, 20}, {30, 20}};
            for (int i = 1; i < 12; ++i) {
                const double a = -pi / 2 + pi * i / 12;
                way.push_back({30 + gap / 2 * std::cos(a), 20 + gap / 2 + gap / 2 * std::sin(a)});
            }
            way.push_back({30, 20 + gap});
            way.push_back({20, 20 + gap});
            SCOPED_TRACE(gap);
            expect_rounded(rolled, way);
        }
}

TEST(Kinks, PathsWithoutKinksStay) {
    const Surface s = plate(false);
    Plan plan = plan_through(s, false, half_turn_way());
    const Line before = plan.strokes[0].sections[0].line;
    round_kinks(s, plan, kSpacing);
    const Line& after = plan.strokes[0].sections[0].line;
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i], before[i]);
}

constexpr double kRadius = 2.4;

double tight_length(const Surface& s, Plan plan) {
    return mark_tight_turns(s, plan, {.radius = kRadius, .spacing = kSpacing}).length;
}

// A way of five straight parts of 9 mm whose corners turn by up to `most` degrees, to the left and to the right.
std::vector<Vec2> zigzag(std::uint64_t& state, double most) {
    std::vector<Vec2> way{{8, 20}};
    for (int i = 0; i < 5; ++i) {
        const double a = (i % 2 == 0 ? 0.5 : -0.5) * most / 180 * pi * (0.2 + 0.8 * next_share(state));
        way.push_back(way.back() + 9.0 * Vec2{std::cos(a), std::sin(a)});
    }
    return way;
}

TEST(Bends, CornersOfUpTo60DegreesGetTheLeastRadius) {
    std::uint64_t state = 1;
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE(round);
        const bool rolled = round % 2 == 1;
        const Surface s = plate(rolled);
        Plan plan = plan_through(s, rolled, zigzag(state, 60));
        const Line before = plan.strokes[0].sections[0].line;
        ASSERT_GT(tight_length(s, plan), 0);
        round_bends(s, plan, {kSpacing, kRadius, 0.8});
        const Line& after = plan.strokes[0].sections[0].line;
        // less than the length for which one place of measurement stands (turns.hpp)
        EXPECT_LT(tight_length(s, plan), surface::curve::turn_reach(kRadius, kSpacing) / 5);
        EXPECT_EQ(kink_length(s, plan), 0);
        expect_moved_within(s, before, after, 0.26 * kSpacing);
    }
}

// Two lines side by side move, but not nearer to each other than allowed.
TEST(Bends, LinesKeepTheirDistance) {
    std::uint64_t state = 2;
    const Surface s = plate(false);
    for (int round = 0; round < 10; ++round) {
        SCOPED_TRACE(round);
        const auto way = zigzag(state, 60);
        std::vector<Vec2> beside;
        for (const Vec2& p : way) beside.push_back(p + Vec2{0, 1.1});
        Plan plan = plan_through(s, false, way);
        plan.strokes.push_back(plan_through(s, false, beside).strokes[0]);
        const auto least = [&] {
            double out = 1e9;
            for (const Place& p : plan.strokes[0].sections[0].line.places)
                for (const Place& q : plan.strokes[1].sections[0].line.places)
                    out = std::min(out, distance(p.point, q.point));
            return out;
        };
        const double before = least();
        round_bends(s, plan, {kSpacing, kRadius, 0.8});
        EXPECT_GT(least(), std::min(before, 0.8) - 0.02);
    }
}

// A half turn from line to line cannot have the least radius.
TEST(Bends, HalfTurnsStay) {
    const Surface s = plate(false);
    Plan plan = plan_through(s, false, half_turn_way());
    const Line before = plan.strokes[0].sections[0].line;
    round_bends(s, plan, {kSpacing, kRadius, 0.8});
    const Line& after = plan.strokes[0].sections[0].line;
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t i = 0; i < after.size(); ++i) EXPECT_EQ(after[i], before[i]);
}

} // namespace
} // namespace filum::surfpath::kinks
