#include "machine/feed.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace filum::machine {
namespace {

double seconds(const std::map<LayerTimes::Feed, double>& lengths, double share) {
    double out = 0;
    for (const auto& [feed, length] : lengths) out += length / std::max(feed.full * share, feed.least);
    return out;
}

// The share that bisection finds.  Without a least feed, the time grows without bound as the share falls.
double bisected(const std::map<LayerTimes::Feed, double>& lengths, double least) {
    if (seconds(lengths, 1) >= least) return 1;
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
        const double mid = (low + high) / 2;
        (seconds(lengths, mid) >= least ? low : high) = mid;
    }
    return high;
}

TEST(Pace, IsTheLargestShareThatTakesLongEnough) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> feed(1, 200), length(0.1, 500), wanted(1, 60);
    for (int job = 0; job < 500; ++job) {
        LayerTimes times;
        times.layers.resize(1);
        const double least = job % 3 == 0 ? 0 : feed(random) / 4;
        const int kinds = 1 + job % 7;
        for (int k = 0; k < kinds; ++k) {
            const double full = feed(random);
            times.layers[0][{full, std::min(full, least)}] += length(random);
        }
        const double time = wanted(random), share = pace(times, time).at(0);
        const double slowest = least > 0 ? seconds(times.layers[0], 0) : std::numeric_limits<double>::infinity();
        if (slowest <= time) {
            EXPECT_NEAR(seconds(times.layers[0], share), std::max(slowest, seconds(times.layers[0], 1)),
                        1e-9 * slowest);
            continue;
        }
        EXPECT_NEAR(share, bisected(times.layers[0], time), 1e-9);
    }
}

TEST(Pace, SlowsABeadThatTheFlowLimits) {
    Profile profile;
    profile.limits.flow = 4; // 10 mm/s for beads of 0.4 mm2
    profile.limits.least_feed = 3;
    ExtrudingMove move{.layer = 0, .length = 10, .volume = 4};
    move.layer = 1;
    EXPECT_DOUBLE_EQ(bead_feed(profile, move), 10);
    profile.pace = {1, 0.5};
    EXPECT_DOUBLE_EQ(bead_feed(profile, move), 5);
    profile.pace = {1, 0.1};
    EXPECT_DOUBLE_EQ(bead_feed(profile, move), 3);
}

TEST(BeadFeed, FirstLayerHasASpeedForAreas) {
    Profile profile;
    profile.feeds.first_layer = 20;
    profile.feeds.first_layer_infill = 40;
    EXPECT_DOUBLE_EQ(bead_feed(profile, {.feature = toolpath::Feature::outer_wall}), 20);
    EXPECT_DOUBLE_EQ(bead_feed(profile, {.feature = toolpath::Feature::bottom}), 40);
    profile.feeds.first_layer_infill = 0;
    EXPECT_DOUBLE_EQ(bead_feed(profile, {.feature = toolpath::Feature::bottom}), 20);
}

TEST(BeadFeed, FirstLayerReplacesSlowSpeedsOrTakesAShareOfEach) {
    using toolpath::Feature;
    Profile profile;
    profile.feeds.first_layer = 20;
    profile.feeds.feature[static_cast<std::size_t>(Feature::solid)] = 15;
    profile.feeds.feature[static_cast<std::size_t>(Feature::wall)] = 60;
    profile.feeds.lift = 5;
    const auto feed = [&](Feature f) { return bead_feed(profile, {.feature = f}); };
    EXPECT_DOUBLE_EQ(feed(Feature::solid), 15);
    profile.feeds.first_layer_exact = true;
    EXPECT_DOUBLE_EQ(feed(Feature::solid), 20);
    EXPECT_DOUBLE_EQ(feed(Feature::wall), 20);
    EXPECT_DOUBLE_EQ(bead_feed(profile, {.role = toolpath::Role::lift}), 5);
    profile.feeds.first_layer_share = 0.4;
    EXPECT_DOUBLE_EQ(feed(Feature::solid), 6);
    EXPECT_DOUBLE_EQ(feed(Feature::wall), 24);
    EXPECT_DOUBLE_EQ(bead_feed(profile, {.layer = 1, .feature = Feature::wall}), 60);
}

// A stream can name any number; the list of times must not take the machine's memory.
TEST(LayerTimes, RefusesNumbersOfLayersThatNoPartHas) {
    toolpath::Span lift;
    lift.role = toolpath::Role::lift;
    lift.points = {{0, 0, 0.2}, {0, 0, 0.4}};
    lift.width = {0.4};
    lift.height = {0.2};
    for (const std::uint32_t layer : {4294967294U, 4294967295U, 100000000U}) {
        LayerTimes times;
        lift.layer = layer;
        EXPECT_THROW(times.add({}, lift), Error);
    }
}

} // namespace
} // namespace filum::machine
