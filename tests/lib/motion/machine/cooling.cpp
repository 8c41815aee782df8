#include "machine/cooling.hpp"

#include "machine/profile.hpp"

#include <gtest/gtest.h>

namespace filum::machine {
namespace {

Cooling some() {
    Cooling c;
    c.most = 200;
    c.least = 100;
    c.idle = 100;
    c.bridge = 255;
    c.fast = 10;
    c.below = 30;
    c.off_layers = 2;
    return c;
}

TEST(Cooling, TheFanFollowsTheTimeOfTheLayer) {
    const Cooling c = some();
    EXPECT_EQ(c.speed(5, 5), 200);
    EXPECT_EQ(c.speed(5, 20), 150);
    EXPECT_EQ(c.speed(5, 30), 100);
    EXPECT_EQ(c.speed(5, 1e9), 100);
    for (double s = 0; s < 40; s += 0.5) EXPECT_GE(c.speed(5, s), c.speed(5, s + 0.5)) << s;
    EXPECT_EQ(c.bridge_speed(5, 5), 255);
}

TEST(Cooling, TheFirstLayersHaveNoneAndTheNextOnesLess) {
    Cooling c = some();
    EXPECT_EQ(c.speed(0, 5), 0);
    EXPECT_EQ(c.bridge_speed(1, 5), 0);
    EXPECT_EQ(c.speed(2, 5), 200);
    c.full_layer = 6; // counted from 1
    EXPECT_EQ(c.speed(2, 5), 50);
    EXPECT_EQ(c.speed(4, 5), 150);
    EXPECT_EQ(c.speed(5, 5), 200);
    c.off_layers = 0;
    c.full_layer = 0;
    EXPECT_EQ(c.speed(0, 5), 200);
}

TEST(Cooling, AProfileCanHaveIt) {
    const Profile p = load_profile("marlin", "cooling.most=255,cooling.least=90,cooling.off_layers=3");
    EXPECT_TRUE(p.cooling.active());
    EXPECT_EQ(p.cooling.off_layers, 3);
    EXPECT_FALSE(load_profile("marlin").cooling.active());
    EXPECT_ANY_THROW((void)load_profile("linuxcnc", "cooling.most=255")); // which has no code for a fan
}

} // namespace
} // namespace filum::machine
