#include "postproc/walk.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::postproc {
namespace {

// The beads of one stroke over these places.
std::vector<Step> beads(const machine::Profile& profile, const std::vector<Vec3>& places) {
    std::vector<Step> out;
    const auto walk = walker(
        profile, {},
        [&](std::span<const Step> steps) {
            for (const Step& s : steps)
                if (s.act == Act::extrude) out.push_back(s);
        },
        nullptr);
    toolpath::Span span;
    span.points = places;
    span.width = {0.5};
    span.height = {0.2};
    span.layer = 1;
    walk->add(span);
    walk->end();
    return out;
}

TEST(Rise, TakesItsTimeAndKeepsTheMaterial) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> step(-4, 4);
    for (int job = 0; job < 100; ++job) {
        std::vector<Vec3> places{{50, 50, 0.4}};
        for (int i = 0; i < 60; ++i) places.push_back(places.back() + Vec3{step(random), step(random), 0});
        machine::Profile profile;
        profile.bed = {.x_min = -1000, .x_max = 1000, .y_min = -1000, .y_max = 1000, .z_max = 100};
        profile.feeds.bead = 20;
        const auto plain = beads(profile, places);
        profile.feeds.rise = 0.5 + job % 4;
        const auto rising = beads(profile, places);
        double volume[2] = {}, length[2] = {}, seconds = 0, before = 0, way = 0;
        for (const Step& s : plain) volume[0] += s.volume, length[0] += s.length;
        for (const Step& s : rising) {
            volume[1] += s.volume;
            length[1] += s.length;
            EXPECT_GE(s.feed, before);
            EXPECT_LE(s.feed, 20);
            before = s.feed;
            way += s.length;
            if (s.feed < 20) seconds += s.length / s.feed;
        }
        EXPECT_NEAR(volume[0], volume[1], 1e-9);
        EXPECT_NEAR(length[0], length[1], 1e-9);
        EXPECT_NEAR(seconds, profile.feeds.rise, 1e-9);
        EXPECT_EQ(rising.back().to, plain.back().to);
    }
}

} // namespace
} // namespace filum::postproc
