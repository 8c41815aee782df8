#include "machine/overhang.hpp"

#include "base/error.hpp"
#include "machine/feed.hpp"

#include <gtest/gtest.h>

namespace filum::machine {
namespace {

TEST(Overhang, TheSpeedIsLinearBetweenTwoShares) {
    const Overhang o{.steps = overhang_feeds("0:100% 0.25:40 0.5:30 1:50%"), .fans = {}};
    EXPECT_DOUBLE_EQ(o.feed(60, 0), 60);
    EXPECT_DOUBLE_EQ(o.feed(60, 0.125), 50);
    EXPECT_DOUBLE_EQ(o.feed(60, 0.25), 40);
    EXPECT_DOUBLE_EQ(o.feed(60, 0.4), 34);
    EXPECT_DOUBLE_EQ(o.feed(60, 0.75), 30);
    EXPECT_DOUBLE_EQ(o.feed(80, 1), 40);
}

TEST(Overhang, BelowTheFirstShareTheSpeedIsTheWallsOwn) {
    const Overhang o{.steps = overhang_feeds("0.25:20"), .fans = {}};
    EXPECT_DOUBLE_EQ(o.feed(60, 0.24), 60);
    EXPECT_DOUBLE_EQ(o.feed(60, 0.25), 20);
    EXPECT_DOUBLE_EQ(o.feed(60, 1), 20);
    EXPECT_DOUBLE_EQ(Overhang{}.feed(60, 1), 60);
}

TEST(Overhang, TextsThatAreNoStepsAreRefused) {
    for (const char* text : {"fast", "0.5", "0.5:", ":3", "0.5:x", "0.5:0", "0.5:-3", "1.1:3", "-0.1:3", "0.5:3 0.5:2",
                             "0.5:3 0.2:2", "0.5:%", "0.5:2000%", "0.5:1e9", "nan:3", "0.5:nan"})
        EXPECT_THROW((void)overhang_feeds(text), Error) << text;
    EXPECT_TRUE(overhang_feeds("").empty());
}

TEST(Overhang, TheFanIsLinearBetweenTwoShares) {
    const Overhang o{.steps = {}, .fans = overhang_fans("0.25:0 0.5:100 1:255")};
    EXPECT_DOUBLE_EQ(o.fan(0.2), -1);
    EXPECT_DOUBLE_EQ(o.fan(0.25), 0);
    EXPECT_DOUBLE_EQ(o.fan(0.3), 20);
    EXPECT_DOUBLE_EQ(o.fan(1), 255);
    EXPECT_DOUBLE_EQ(Overhang{}.fan(1), -1);
    for (const char* text : {"0.5:50%", "0.5:-1", "0.5:1e5", "0.5:nan", "1", "0.5:1 0.5:2"})
        EXPECT_THROW((void)overhang_fans(text), Error) << text;
}

TEST(Overhang, TheFanOfALayerIsRaisedAndNeverLowered) {
    Cooling c;
    c.most = 200;
    c.least = c.idle = 60;
    c.fast = 5;
    c.below = 30;
    c.off_layers = 1;
    c.full_layer = 4;
    EXPECT_DOUBLE_EQ(c.raised(10, 100, 150), 150);
    EXPECT_DOUBLE_EQ(c.raised(10, 100, 20), 60);
    EXPECT_DOUBLE_EQ(c.raised(10, 100, -1), 60);
    EXPECT_DOUBLE_EQ(c.raised(10, 2, 150), 200);
    EXPECT_DOUBLE_EQ(c.raised(1, 100, 150), 50); // a third of the way up
    EXPECT_DOUBLE_EQ(c.raised(0, 100, 150), 0);
}

TEST(Overhang, WallsOverAirHaveItsFeed) {
    Profile p;
    p.feeds.feature[static_cast<std::size_t>(toolpath::Feature::outer_wall)] = 40;
    p.overhang.steps = overhang_feeds("0:100% 1:20");
    ExtrudingMove move{.layer = 1, .feature = toolpath::Feature::outer_wall, .over_air = 50};
    EXPECT_DOUBLE_EQ(bead_feed(p, move), 30);
    move.over_air = 0;
    EXPECT_DOUBLE_EQ(bead_feed(p, move), 40);
    move.over_air = 50;
    move.role = toolpath::Role::jog; // a join keeps its own
    EXPECT_DOUBLE_EQ(bead_feed(p, move), p.feeds.jog);
    move = {.layer = 0, .feature = toolpath::Feature::outer_wall, .over_air = 50};
    EXPECT_DOUBLE_EQ(bead_feed(p, move), std::min(30.0, p.feeds.first_layer));
    p.overhang.steps = overhang_feeds("0:1000%");
    EXPECT_DOUBLE_EQ(bead_feed(p, {.layer = 1, .feature = toolpath::Feature::outer_wall, .over_air = 5}),
                     p.motion.max_speed);
}

} // namespace
} // namespace filum::machine
