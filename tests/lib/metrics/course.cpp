#include "metrics/course.hpp"

#include "metrics/pace.hpp"
#include "toolpaths.hpp"

namespace filum::metrics {

namespace {

using toolpath::Role;

Course course(const std::vector<toolpath::Span>& spans) {
    Course c;
    for (const auto& s : spans) follow(c, s);
    return c;
}

TEST(Course, OfNothing) {
    EXPECT_EQ(course({}).strokes(), 0);
    EXPECT_EQ(course({travel({0, 0, 0}, {9, 9, 9})}).strokes(), 0);
}

TEST(Course, OneStrokeHasNoStop) {
    auto lift = bead({{10, 0, 0.2}, {10, 0, 0.4}}, 0.4, 0.2, 1);
    lift.role = Role::lift;
    const Course c = course({bead({{0, 0, 0.2}, {10, 0, 0.2}}), lift, bead({{10, 0, 0.4}, {0, 0, 0.4}}, 0.4, 0.2, 1)});
    EXPECT_EQ(c.strokes(), 1);
    EXPECT_EQ(c.stops, 0);
    EXPECT_EQ(c.joins[static_cast<std::size_t>(Role::lift)], 1);
    EXPECT_NEAR(c.length[0], 20, 1e-12);
    EXPECT_NEAR(c.volume[0], 20 * 0.08, 1e-12);
    EXPECT_EQ(c.jumps, 0);
}

TEST(Course, BreaksFallIntoClasses) {
    const Course c = course({
        bead({{0, 0, 0.2}, {10, 0, 0.2}}), travel({10, 0, 0.2}, {10, 0.4, 0.2}),                // a hop
        bead({{10, 0.4, 0.2}, {0, 0.4, 0.2}}), travel({0, 0.4, 0.2}, {0, 5, 0.2}),              // in the layer
        bead({{0, 5, 0.2}, {10, 5, 0.2}}), travel({10, 5, 0.2}, {0, 0, 0.4}),                   // to the next one
        bead({{0, 0, 0.4}, {10, 0, 0.4}}, 0.4, 0.2, 1), travel({10, 0, 0.4}, {10, 0.03, 0.4}),  // too short to be one
        bead({{10, 0.03, 0.4}, {10, 3, 0.4}}, 0.4, 0.2, 1), travel({10, 3, 0.4}, {10, 3, 0.6}), // a bare layer step
        bead({{10, 3, 0.6}, {0, 3, 0.6}}, 0.4, 0.2, 2), travel({0, 3, 0.6}, {0, 3, 1.6}),       // straight up, far
        bead({{0, 3, 1.6}, {5, 3, 1.6}}, 0.4, 0.2, 7), travel({5, 3, 1.6}, {90, 90, 9}),        // after the end: no gap
    });
    EXPECT_EQ(c.stops, 3);
    EXPECT_EQ(c.breaks, 4);
    EXPECT_EQ(c.strokes(), 5);
    EXPECT_EQ(c.hops, 1);
    EXPECT_EQ(c.travels, 1);
    EXPECT_EQ(c.climbs, 2);
    EXPECT_NEAR(c.longest_gap, std::hypot(10, 5), 1e-12);
}

TEST(Course, SpansThatDoNotMeetAreJumps) {
    const Course c = course({bead({{0, 0, 0.2}, {10, 0, 0.2}}), bead({{10, 2, 0.2}, {0, 2, 0.2}})});
    EXPECT_EQ(c.jumps, 1);
    EXPECT_EQ(c.stops, 1);
    EXPECT_EQ(c.strokes(), 2);
    EXPECT_NEAR(c.length[static_cast<std::size_t>(Role::travel)], 2, 1e-12);
}

machine::Profile profile() {
    machine::Profile p;
    p.feeds.bead = p.feeds.first_layer = 60, p.feeds.travel = 100;
    p.motion.acceleration = 1200, p.motion.travel_acceleration = 1000;
    p.bed.z_max = 100;
    return p;
}

TEST(Pace, OfOneMoveIsATrapezoid) {
    Pace pace(profile());
    pace.add(bead({{0, 0, 0.2}, {30, 0, 0.2}}, 0.4, 0.2, 1));
    // 1.5 mm each for speeding up and slowing down, 0.05 s each, and 27 mm at 60 mm/s.
    EXPECT_NEAR(pace.seconds(), 27.0 / 60 + 2 * 60.0 / 1200, 1e-9);
}

TEST(Pace, StraightPiecesTakeAsLongAsTheWhole) {
    Pace pace(profile());
    std::vector<geom::Vec3> points;
    for (int k = 0; k <= 300; ++k) points.push_back({0.1 * k, 0, 0.2});
    pace.add(bead(points, 0.4, 0.2, 1));
    EXPECT_NEAR(pace.seconds(), 27.0 / 60 + 2 * 60.0 / 1200, 1e-6);
}

TEST(Pace, ATravelRetractsRisesAndComesBack) {
    auto p = profile();
    p.travel.lift = 1, p.travel.retract = 2, p.travel.retract_speed = 20, p.travel.extra = 0, p.travel.min_length = 0;
    p.feeds.z = p.motion.max_speed_z = 10;
    Pace plain(p), broken(p);
    plain.add(bead({{0, 0, 0.2}, {30, 0, 0.2}}, 0.4, 0.2, 1));
    broken.add(bead({{0, 0, 0.2}, {30, 0, 0.2}}, 0.4, 0.2, 1));
    broken.add(travel({30, 0, 0.2}, {30, 40, 0.2}));
    broken.add(bead({{30, 40, 0.2}, {0, 40, 0.2}}, 0.4, 0.2, 1));
    const double z = 1.0 / 10 + 10.0 / 1000, xy = 40.0 / 100 + 100.0 / 1000;
    const double standing = 2 * plain.seconds() + 2 * 2.0 / 20 + 2 * z + xy; // with a full stop between all of them
    EXPECT_LE(broken.seconds(), standing + 1e-9);
    EXPECT_GE(broken.seconds(), standing - 0.05); // corners are passed a little faster
}

TEST(Pace, OfNothing) {
    Pace pace(profile());
    EXPECT_EQ(pace.seconds(), 0);
    pace.add(travel({0, 0, 0}, {50, 0, 0}));
    EXPECT_EQ(pace.seconds(), 0);
}

} // namespace

} // namespace filum::metrics
