// The axes of an arm along strokes: the tool stands where it should all along, and within limits. Errors name the place
// that it cannot reach.
#include "kinematics/follow.hpp"

#include "arms.hpp"
#include "geom/angle.hpp"

#include <gtest/gtest.h>

using namespace arms;
using kinematics::ArmSetup;
using kinematics::FollowFailure;
using kinematics::FollowResult;
using kinematics::StartPosture;
using kinematics::TimedFrame;

namespace {

using geom::kDegree;

const Posture kReady{0, 0.1, 0.2, 0.05, 1.2, 0.1};
const Frame kTool{{}, {0, 0, 150}};

Arm irb() {
    Arm out = industrial(495, 175, 900, 175, 960, 135);
    const double low[] = {-180, -90, -180, -400, -125, -400}, high[] = {180, 150, 75, 400, 120, 400};
    for (std::size_t k = 0; k < kAxes; ++k) {
        out.axes[k].min = low[k] * kDegree;
        out.axes[k].max = high[k] * kDegree;
    }
    return out;
}

// Tool down at a place, its x axis turned by `turn`.
Frame down(double x, double y, double z, double turn = 0) {
    return {geom::rotation_of({0, 0, -1}, {std::cos(turn), std::sin(turn), 0}), {x, y, z}};
}

std::vector<TimedFrame> line(const Frame& from, const Frame& to, int n, double seconds = 10) {
    std::vector<TimedFrame> out;
    for (int i = 0; i <= n; ++i)
        out.push_back({kinematics::between(from, to, i / static_cast<double>(n)), i == 0 ? 0 : seconds / n});
    return out;
}

// Where the tip is for a posture, by the tests' own kinematics.
Frame tip(const ArmSetup& c, const Posture& q) { return driven(c.arm, q) * c.tool; }

void expect_followed(const ArmSetup& c, const std::vector<TimedFrame>& stands, const FollowResult& f,
                     const char* what) {
    ASSERT_EQ(f.hindrance.trouble, FollowFailure::none)
        << what << " axis " << f.hindrance.axis << " stand " << f.hindrance.stand << " by " << f.hindrance.amount;
    ASSERT_EQ(f.postures.size(), stands.size()) << what;
    for (std::size_t i = 0; i < stands.size(); ++i) {
        const Frame wanted = kinematics::spun(stands[i].tip, f.spin[i]);
        EXPECT_LT(off(tip(c, f.postures[i]), wanted), 1e-4) << what << " " << i;
        for (std::size_t k = 0; k < kAxes; ++k) {
            EXPECT_GE(f.postures[i][k], c.arm.axes[k].min - 1e-9) << what;
            EXPECT_LE(f.postures[i][k], c.arm.axes[k].max + 1e-9) << what;
            if (i > 0) {
                EXPECT_LE(std::abs(f.postures[i][k] - f.postures[i - 1][k]), f.needed[i] * c.arm.axes[k].speed + 1e-9);
            }
        }
        if (i == 0) continue;
        // No flip in between: axes half way take the tip near the middle of the way.
        Posture middle;
        for (std::size_t k = 0; k < kAxes; ++k) middle[k] = (f.postures[i][k] + f.postures[i - 1][k]) / 2;
        const double way = distance(stands[i].tip.origin, stands[i - 1].tip.origin);
        const geom::Vec3 half = 0.5 * (stands[i].tip.origin + stands[i - 1].tip.origin);
        EXPECT_LT(distance(tip(c, middle).origin, half), 1 + 0.1 * way) << what << " " << i;
    }
}

} // namespace

TEST(Follow, StraightStrokesKeepTheSpin) {
    Random random;
    const ArmSetup c{irb(), kTool, true, 5 * kDegree};
    for (int i = 0; i < 40; ++i) {
        const auto place = [&] {
            const geom::Vec3 at{random(800, 1300), random(-400, 400), random(100, 600)};
            return down(at.x, at.y, at.z);
        };
        const auto stands = line(place(), place(), 30);
        const auto f = kinematics::follow(c, stands, {kReady, 0, true});
        expect_followed(c, stands, f, "line");
        for (const double s : f.spin) EXPECT_EQ(s, 0);
        // and on from there
        const auto more = line(stands.back().tip, place(), 5);
        expect_followed(c, more, kinematics::follow(c, more, {f.postures.back(), 0, false}), "on");
    }
}

TEST(Follow, ARoundToolUnwindsOnTheWay) {
    Arm arm = irb();
    arm.axes[5].min = -200 * kDegree;
    arm.axes[5].max = 200 * kDegree;
    std::vector<TimedFrame> stands; // the tool's x axis turns round three times
    for (int i = 0; i <= 600; ++i) stands.push_back({down(1000, -300 + i, 300, i * 1.8 * kDegree), 0.05});
    const FollowResult held = kinematics::follow({arm, kTool, false, 0}, stands, {kReady, 0, true});
    EXPECT_EQ(held.hindrance.trouble, FollowFailure::limit);
    EXPECT_EQ(held.hindrance.axis, 5U);
    EXPECT_GT(held.hindrance.stand, 100U);
    EXPECT_GT(held.hindrance.amount, 0);
    EXPECT_LT(held.hindrance.amount, 10 * kDegree);
    const ArmSetup round{arm, kTool, true, 5 * kDegree};
    expect_followed(round, stands, kinematics::follow(round, stands, {kReady, 0, true}), "unwound");
}

TEST(Follow, ARoundToolGoesRoundASingularity) {
    // A tool that leans: the wrist is stretched, axes 4 and 6 in line, where it points along the fore arm.
    const ArmSetup fixed{irb(), {geom::about({0, 1, 0}, 50 * kDegree), {120, 0, 150}}, false, 5 * kDegree};
    Posture q = kReady;
    q[3] = 0;
    q[4] = 0;
    const Frame through = tip(fixed, q);
    const auto aside = [&](double y) { return Frame{through.turn, through.origin + geom::Vec3{0, y, 0}}; };
    const auto stands = line(aside(-150), aside(150), 61, 15);
    q[4] = 0.1;
    const auto ways = kinematics::inverse(fixed.arm, stands[0].tip * geom::inverse(fixed.tool), q);
    q = *std::ranges::min_element(ways, {}, [&](const Posture& w) { return kinematics::apart(w, q); });
    const FollowResult f = kinematics::follow(fixed, stands, {q, 0, false});
    EXPECT_EQ(f.hindrance.trouble, FollowFailure::jump);
    EXPECT_NEAR(static_cast<double>(f.hindrance.stand), 31, 2);
    EXPECT_LT(f.nearest.angle, 1 * kDegree);
    ArmSetup round = fixed;
    round.round = true;
    const FollowResult g = kinematics::follow(round, stands, {q, 0, true});
    expect_followed(round, stands, g, "round");
    EXPECT_GE(g.nearest.angle, 5 * kDegree);
    EXPECT_LT(*std::max_element(g.needed.begin(), g.needed.end()), 0.25);
}

TEST(Follow, WhatIsOutOfReachIsToldWithItsPlace) {
    const ArmSetup c{irb(), kTool, true, 5 * kDegree};
    const auto stands = line(down(1000, 0, 300), down(3000, 0, 300), 100);
    const FollowResult f = kinematics::follow(c, stands, {kReady, 0, true});
    EXPECT_EQ(f.hindrance.trouble, FollowFailure::reach);
    const double reach = std::hypot(900, 0) + std::hypot(960, 175); // of the wrist, from axis 2, both in line
    const double wrist = std::sqrt(reach * reach - std::pow(300 + 150 + 135 - 495, 2)) + 175;
    EXPECT_NEAR(stands[f.hindrance.stand].tip.origin.x, wrist, 40);
    EXPECT_GT(f.hindrance.amount, 0);
    EXPECT_LT(f.hindrance.amount, 25);
    const auto nowhere = line(down(4000, 0, 300), down(3900, 0, 300), 3);
    const FollowResult g = kinematics::follow(c, nowhere, {kReady, 0, true});
    EXPECT_EQ(g.hindrance.trouble, FollowFailure::reach);
    EXPECT_EQ(g.hindrance.stand, 0U);
    EXPECT_NEAR(g.hindrance.amount, 4000 - wrist, 60);
}

TEST(Follow, AFirstStandBeyondALimitSaysWhich) {
    Arm arm = irb();
    arm.axes[0].min = -0.5;
    arm.axes[0].max = 0.5;
    const auto stands = line(down(0, 1100, 300), down(10, 1100, 300), 3);
    const FollowResult f = kinematics::follow({arm, kTool, true, 0}, stands, {kReady, 0, true});
    EXPECT_EQ(f.hindrance.trouble, FollowFailure::limit);
    EXPECT_EQ(f.hindrance.stand, 0U);
}

TEST(Follow, AllBuildsFollowACircle) {
    for (const auto& [name, arm] : all()) {
        ArmSetup c{arm, kTool, true, 3 * kDegree};
        const Posture ready = name == "ur10e" ? Posture{-1.6, -1.8, -1.9, -1, 1.57, 0} : kReady;
        const Frame middle = tip(c, ready);
        std::vector<TimedFrame> stands;
        for (int i = 0; i <= 120; ++i) {
            const double t = i * 3 * kDegree;
            stands.push_back({middle * Frame{{}, {60 * std::cos(t) - 60, 60 * std::sin(t), 0}}, 0.2});
        }
        const StartPosture at{ready, 0, name == "general" ? false : true};
        expect_followed(c, stands, kinematics::follow(c, stands, at), name.c_str());
    }
}
