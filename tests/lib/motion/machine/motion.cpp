// Print times against what physics says.
#include "machine/motion.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace filum;
using machine::Clock;

namespace {

machine::Profile motion() {
    machine::Profile out;
    machine::Motion& m = out.motion;
    m.max_speed = 200;
    m.max_speed_z = 10;
    m.acceleration = 1000;
    m.travel_acceleration = 2000;
    m.corner_speed = 5;
    return out;
}

machine::PlannedMove straight(geom::Vec3 step, double feed, bool extruding) {
    return {.step = step, .feed = feed, .extruding = extruding};
}

} // namespace

TEST(Clock, OneMoveIsATrapezoid) {
    Clock c(motion());
    c.move(straight({100, 0, 0}, 100, true));
    EXPECT_NEAR(c.total(), 1.0 + 0.1, 1e-12); // length / v + v / a
    Clock shorter(motion());
    shorter.move(straight({0, 2.5, 0}, 100, true)); // never reaches its feed: 2 sqrt(l / a)
    EXPECT_NEAR(shorter.total(), 0.1, 1e-12);
    Clock travel(motion());
    travel.move(straight({100, 0, 0}, 100, false));
    EXPECT_NEAR(travel.total(), 1.05, 1e-12);
    Clock up(motion());
    up.move(straight({0, 0, 1}, 100, true));
    EXPECT_NEAR(up.total(), 0.1 + 0.01, 1e-12);
}

TEST(Clock, AStraightLineInManyPiecesTakesAsLong) {
    for (const int n : {2, 10, 1000, 20000}) {
        Clock c(motion());
        for (int i = 0; i < n; ++i) c.move(straight({300.0 / n, 400.0 / n, 0}, 100, true));
        EXPECT_NEAR(c.total(), 5.1, 1e-6) << n;
    }
}

TEST(Clock, ACornerIsPassedAtItsSpeed) {
    Clock c(motion());
    c.move(straight({100, 0, 0}, 100, true));
    c.move(straight({0, 100, 0}, 100, true));
    // each leg: from 0 to 100 and down to 5, over 100 mm
    const double a = 1000, up = 100 * 100 / (2 * a), down = (100 * 100 - 25) / (2 * a);
    EXPECT_NEAR(c.total(), 2 * (100 / a + 95 / a + (100 - up - down) / 100), 1e-9);
    Clock back(motion());
    back.move(straight({100, 0, 0}, 100, true));
    back.move(straight({-100, 0, 0}, 100, true));
    EXPECT_NEAR(back.total(), 2.2, 1e-9);
}

TEST(Clock, TotalsAddUpOverPauses) {
    Clock c(motion());
    c.move(straight({100, 0, 0}, 100, true));
    c.pause(2);
    c.move(straight({100, 0, 0}, 100, true));
    EXPECT_NEAR(c.total(), 2 * 1.1 + 2, 1e-12);
    EXPECT_NEAR(c.total(), 2 * 1.1 + 2, 1e-12);
    Clock still(motion());
    still.move(straight({0, 0, 0}, 100, true));
    EXPECT_EQ(still.total(), 0);
}

TEST(Clock, ALongCurveIsNeverFasterThanItsFeed) {
    Clock c(motion());
    constexpr int n = 50000;
    double length = 0;
    for (int i = 0; i < n; ++i) {
        const double t = 2 * std::numbers::pi * i / 1000, step = 0.05;
        c.move(straight({step * std::cos(t), step * std::sin(t), 0}, 60, true));
        length += step;
    }
    EXPECT_GE(c.total(), length / 60);
    EXPECT_LT(c.total(), length / 60 * 1.05); // a circle of 8 mm radius does not slow it
}
