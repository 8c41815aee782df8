#include "metrics/planar/path_statistics.hpp"

#include "metrics/planar/pace.hpp"
#include "toolpaths.hpp"

namespace filum::metrics::planar {

namespace {

using toolpath::Role;

PathStatistics statistics_of(const std::vector<toolpath::Span>& spans) {
    PathStatistics c;
    for (const auto& s : spans) follow(c, s);
    return c;
}

TEST(PathStatistics, OfNothing) {
    EXPECT_EQ(statistics_of({}).strokes(), 0);
    EXPECT_EQ(statistics_of({travel({0, 0, 0}, {9, 9, 9})}).strokes(), 0);
}

TEST(PathStatistics, OneStrokeHasNoStop) {
    auto lift = bead({{10, 0, 0.2}, {10, 0, 0.4}}, 0.4, 0.2, 1);
    lift.role = Role::lift;
    const PathStatistics c =
        statistics_of({bead({{0, 0, 0.2}, {10, 0, 0.2}}), lift, bead({{10, 0, 0.4}, {0, 0, 0.4}}, 0.4, 0.2, 1)});
    EXPECT_EQ(c.strokes(), 1);
    EXPECT_EQ(c.stops, 0);
    EXPECT_EQ(c.joins[static_cast<std::size_t>(Role::lift)], 1);
    EXPECT_NEAR(c.length[0], 20, 1e-12);
    EXPECT_NEAR(c.volume[0], 20 * 0.08, 1e-12);
    EXPECT_EQ(c.jumps, 0);
}

TEST(PathStatistics, BreaksFallIntoClasses) {
    auto step = travel({10, 3, 0.4}, {10, 3, 0.6});
    step.retraction = toolpath::Retraction::none;
    const PathStatistics c = statistics_of({
        bead({{0, 0, 0.2}, {10, 0, 0.2}}), travel({10, 0, 0.2}, {10, 0.4, 0.2}),               // a hop
        bead({{10, 0.4, 0.2}, {0, 0.4, 0.2}}), travel({0, 0.4, 0.2}, {0, 5, 0.2}),             // in the layer
        bead({{0, 5, 0.2}, {10, 5, 0.2}}), travel({10, 5, 0.2}, {0, 0, 0.4}),                  // to the next one
        bead({{0, 0, 0.4}, {10, 0, 0.4}}, 0.4, 0.2, 1), travel({10, 0, 0.4}, {10, 0.03, 0.4}), // too short to be one
        bead({{10, 0.03, 0.4}, {10, 3, 0.4}}, 0.4, 0.2, 1), step,                              // a bare layer step
        bead({{10, 3, 0.6}, {0, 3, 0.6}}, 0.4, 0.2, 2), travel({0, 3, 0.6}, {0, 3, 1.6}),      // straight up, far
        bead({{0, 3, 1.6}, {5, 3, 1.6}}, 0.4, 0.2, 7), travel({5, 3, 1.6}, {90, 90, 9}),       // after the end: no gap
    });
    EXPECT_EQ(c.stops, 4);
    EXPECT_EQ(c.breaks, 4);
    EXPECT_EQ(c.strokes(), 5);
    EXPECT_EQ(c.hops, 1);
    EXPECT_EQ(c.travels, 1);
    EXPECT_EQ(c.climbs, 2);
    EXPECT_NEAR(c.longest_gap, std::hypot(10, 5), 1e-12);
}

// Machines take back on their way up, too, unless a setting forbids it.
TEST(PathStatistics, AWayStraightUpIsAStop) {
    const auto stops = [](toolpath::Retraction retraction) {
        auto up = travel({10, 0, 0.4}, {10, 0.04, 0.8});
        up.retraction = retraction;
        return statistics_of(
            {bead({{0, 0, 0.4}, {10, 0, 0.4}}), up, bead({{10, 0.04, 0.8}, {0, 0, 0.8}}, 0.4, 0.2, 3)});
    };
    EXPECT_EQ(stops(toolpath::Retraction::by_machine).stops, 1);
    EXPECT_EQ(stops(toolpath::Retraction::by_machine).hops, 1);
    EXPECT_EQ(stops(toolpath::Retraction::none).stops, 0);
    EXPECT_EQ(stops(toolpath::Retraction::none).strokes(), 1);
}

TEST(PathStatistics, SpansThatDoNotMeetAreJumps) {
    const PathStatistics c = statistics_of({bead({{0, 0, 0.2}, {10, 0, 0.2}}), bead({{10, 2, 0.2}, {0, 2, 0.2}})});
    EXPECT_EQ(c.jumps, 1);
    EXPECT_EQ(c.stops, 1);
    EXPECT_EQ(c.strokes(), 2);
    EXPECT_NEAR(c.length[static_cast<std::size_t>(Role::travel)], 2, 1e-12);
}

machine::Profile profile() {
    machine::Profile p;
    p.feeds.bead = p.feeds.first_layer = 60;
    p.feeds.travel = 100;
    p.motion.acceleration = 1200;
    p.motion.travel_acceleration = 1000;
    p.bed.z_max = 100;
    return p;
}

// From above the first stroke, mm, at feeds.z.
double approach(const machine::Profile& p) { return machine::stop_to_stop(5, p.feeds.z, p.motion.travel_acceleration); }

double seconds(const machine::Profile& p, const std::vector<toolpath::Span>& spans) {
    Pace pace(p);
    for (const auto& span : spans) pace.add(span);
    return pace.seconds();
}

TEST(Pace, OfOneMoveIsATrapezoid) {
    // 1.5 mm each for speeding up and slowing down, 0.05 s each, and 27 mm at 60 mm/s.
    EXPECT_NEAR(seconds(profile(), {bead({{0, 0, 0.2}, {30, 0, 0.2}}, 0.4, 0.2, 1)}),
                approach(profile()) + 27.0 / 60 + 2 * 60.0 / 1200, 1e-9);
}

TEST(Pace, StraightPiecesTakeAsLongAsTheWhole) {
    std::vector<geom::Vec3> points;
    for (int k = 0; k <= 300; ++k) points.push_back({0.1 * k, 0, 0.2});
    EXPECT_NEAR(seconds(profile(), {bead(points, 0.4, 0.2, 1)}), approach(profile()) + 27.0 / 60 + 2 * 60.0 / 1200,
                1e-6);
}

TEST(Pace, ATravelRetractsRisesAndComesBack) {
    auto p = profile();
    p.travel.lift = 1;
    p.travel.retract = 2;
    p.travel.retract_speed = 20;
    p.travel.extra = 0;
    p.travel.min_length = 0;
    p.feeds.z = p.motion.max_speed_z = 10;
    const auto first = bead({{0, 0, 0.2}, {30, 0, 0.2}}, 0.4, 0.2, 1);
    const double plain = seconds(p, {first});
    const double broken =
        seconds(p, {first, travel({30, 0, 0.2}, {30, 40, 0.2}), bead({{30, 40, 0.2}, {0, 40, 0.2}}, 0.4, 0.2, 1)});
    const double z = 1.0 / 10 + 10.0 / 1000, xy = 40.0 / 100 + 100.0 / 1000;
    // with a full stop between all of them
    const double standing = plain + (plain - approach(p)) + 2 * 2.0 / 20 + 2 * z + xy;
    EXPECT_LE(broken, standing + 1e-9);
    EXPECT_GE(broken, standing - 0.05); // corners are passed a little faster
}

TEST(Pace, WhatNoMachineCanDoHasNoTime) {
    Pace pace(profile());
    pace.add(bead({{0, 0, 0.2}, {30, 0, 0.2}}, 0.4, 0.2, 1));
    pace.add(bead({{40, 0, 0.2}, {30, 0, 0.2}}, 0.4, 0.2, 1)); // they do not meet
    EXPECT_LT(pace.seconds(), 0);
    EXPECT_NE(pace.why().find("from where the one before ended"), std::string::npos);
    EXPECT_NEAR(pace.tools().at(0).laid, 40, 1e-9);
}

// A stroke of plastic, then two of fibre: 100 mm of it, and 20 mm that no head of 45 mm can lay.
TEST(Pace, ChargesEachToolWithWhatItDoes) {
    auto p = profile();
    p.fibre.cut_to_nozzle = p.fibre.least_path = 45;
    p.fibre.anchor = 6;
    p.fibre.anchor_feed = 0.5;
    p.fibre.feed = 10;
    p.fibre.tail_feed = 5;
    p.fibre.tension_dwell = 2;
    p.fibre.cut_dwell = 3;
    p.fibre.prime = 7;
    p.fibre.prime_speed = 3.5;
    const auto of_fibre = [](toolpath::Span span) {
        span.tool = 1;
        return span;
    };
    Pace pace(p);
    pace.add(bead({{0, 0, 0.2}, {30, 0, 0.2}}, 0.4, 0.2, 1));
    pace.add(travel({30, 0, 0.2}, {0, 10, 0.2}));
    pace.add(of_fibre(bead({{0, 10, 0.2}, {60, 10, 0.2}}, 1, 0.2, 1)));
    pace.add(of_fibre(bead({{60, 10, 0.2}, {60, 50, 0.2}}, 1, 0.2, 1)));
    pace.add(of_fibre(travel({60, 50, 0.2}, {0, 70, 0.2})));
    pace.add(of_fibre(bead({{0, 70, 0.2}, {20, 70, 0.2}}, 1, 0.2, 1)));
    const double all = pace.seconds();
    ASSERT_EQ(pace.tools().size(), 2U);
    const ToolShare &plastic = pace.tools().at(0), &fibre = pace.tools().at(1);
    EXPECT_FALSE(plastic.fibre);
    EXPECT_EQ(plastic.strokes, 1U);
    EXPECT_EQ(plastic.cuts, 0U);
    EXPECT_NEAR(plastic.laid, 30, 1e-9);
    EXPECT_NEAR(plastic.volume, 30 * 0.08, 1e-9);
    EXPECT_NEAR(plastic.print_seconds, 27.0 / 60 + 2 * 60.0 / 1200, 1e-9);
    EXPECT_TRUE(fibre.fibre);
    EXPECT_EQ(fibre.strokes, 2U);
    EXPECT_EQ(fibre.cuts, 2U);
    EXPECT_EQ(fibre.too_short, 1U);
    EXPECT_NEAR(fibre.laid, 120, 1e-9);
    EXPECT_NEAR(fibre.volume, 24, 1e-9);
    EXPECT_NEAR(fibre.travel, std::hypot(60, 20), 1e-9);
    // anchor, pause, 49 mm pulled, cut, tail; the short one takes no time
    const double laid = 6 / 0.5 + 2 + 4.9 + 3 + 9;
    EXPECT_NEAR(fibre.print_seconds, laid, 0.1);
    EXPECT_GE(fibre.print_seconds, laid);
    EXPECT_GT(fibre.travel_seconds, 2); // 7 mm into the air
    EXPECT_NEAR(plastic.print_seconds + plastic.travel_seconds + fibre.print_seconds + fibre.travel_seconds, all, 1e-9);
}

TEST(Pace, OfNothing) {
    Pace pace(profile());
    EXPECT_EQ(pace.seconds(), 0);
    pace.add(travel({0, 0, 0}, {50, 0, 0}));
    EXPECT_EQ(pace.seconds(), 0);
}

} // namespace

} // namespace filum::metrics::planar
