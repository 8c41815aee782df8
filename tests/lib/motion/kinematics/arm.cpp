// Arms stand where their postures say, and inverse() finds every posture that stands there.
#include "arms.hpp"

#include "geom/angle.hpp"

#include <gtest/gtest.h>

using namespace arms;
using kinematics::Build;
using kinematics::Shortfall;
using kinematics::Singular;

TEST(Arm, TablesStandWhereTheMakersSay) {
    const Frame ur = kinematics::forward(ur10e(), {});
    EXPECT_LT(distance(ur.origin, {-1184.25, -290.7, 60.85}), 1e-9);
    EXPECT_LT(distance(ur.turn.z, {0, -1, 0}), 1e-12);
    // straight up
    const Frame up = kinematics::forward(ur10e(), {0, -pi / 2, 0, -pi / 2, 0, 0});
    EXPECT_LT(distance(up.origin, {0, -290.7, 180.7 + 612.7 + 571.55 + 119.85}), 1e-9);
    const auto irb = industrial(495, 175, 900, 175, 960, 135);
    EXPECT_LT(distance(kinematics::forward(irb, {}).origin, {1270, 0, 1570}), 1e-9);
    EXPECT_EQ(irb.build, Build::wrist);
    EXPECT_EQ(ur10e().build, Build::parallel);
    EXPECT_EQ(all().back().second.build, Build::general);
}

TEST(Arm, ForwardIsAProductOfTurns) {
    Random random;
    for (const auto& [name, arm] : all())
        for (int i = 0; i < 100; ++i) {
            Posture q;
            for (double& t : q) t = random(-7, 7);
            EXPECT_LT(off(kinematics::forward(arm, q), driven(arm, q)), 1e-8) << name;
        }
}

TEST(Arm, EveryWayToStandIsFoundAndStandsThere) {
    Random random;
    for (const auto& [name, arm] : all()) {
        const bool general = arm.build == Build::general;
        std::size_t most = 0;
        for (int i = 0; i < (general ? 60 : 500); ++i) {
            Posture q;
            for (double& t : q) t = random(-pi, pi);
            if (kinematics::nearness(arm, q).angle < 0.03) continue;
            const Frame flange = driven(arm, q);
            const auto ways = kinematics::inverse(arm, flange, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6});
            double nearest = 100;
            for (const Posture& w : ways) {
                EXPECT_LT(off(driven(arm, w), flange), 1e-5) << name;
                nearest = std::min(nearest, kinematics::apart(kinematics::unwrapped(w, q), q));
                for (const double t : w) EXPECT_LE(std::abs(t), pi + 1e-12);
            }
            EXPECT_FALSE(ways.empty()) << name;
            EXPECT_LT(nearest, general ? 10 : 1e-6) << name << " " << i;
            for (std::size_t a = 0; a < ways.size(); ++a)
                for (std::size_t b = 0; b < a; ++b)
                    EXPECT_GT(kinematics::apart(kinematics::unwrapped(ways[a], ways[b]), ways[b]), 1e-7);
            most = std::max(most, ways.size());
        }
        EXPECT_GE(most, general ? 4U : 8U) << name;
        EXPECT_LE(most, 16U);
    }
}

TEST(Arm, WhatIsOutOfReachHasNoWayAndSaysByHowMuch) {
    for (const auto& [name, arm] : all()) {
        if (arm.build == Build::general) continue;
        const bool wrist = arm.build == Build::wrist;
        // Stretched level from the shoulder, and on from there.
        Frame far = kinematics::forward(arm, {});
        const double length = distance(arm.axes[2].point, arm.axes[1].point) +
                              distance(wrist ? arm.centre : arm.axes[3].point, arm.axes[2].point);
        far.origin = {5000, 0, arm.axes[1].point.z};
        Shortfall lack;
        EXPECT_TRUE(kinematics::inverse(arm, far, {}, &lack).empty()) << name;
        EXPECT_GT(lack.length, 5000 - length - 500) << name;
        EXPECT_LT(lack.length, 5000 - length + 500) << name;
        if (!wrist) continue;
        // The wrist's centre 1 mm farther than upper and fore arm go.
        Posture straight{0, 0.3, 0, 0.2, 0.7, 0};
        const geom::Vec3 upper = arm.axes[2].point - arm.axes[1].point, fore = arm.centre - arm.axes[2].point;
        const geom::Vec3 in_plane{fore.x, 0, fore.z};
        straight[2] = std::atan2(upper.x, upper.z) - std::atan2(in_plane.x, in_plane.z);
        Frame at = kinematics::forward(arm, straight);
        EXPECT_LT(kinematics::nearness(arm, straight).angle, 1e-6) << name;
        const Frame hub{{}, arm.axes[1].point};
        const geom::Vec3 centre = at * (geom::inverse(arm.flange) * arm.centre);
        geom::Vec3 out = centre - hub.origin;
        out.y = 0;
        at.origin = at.origin + 1 / norm(out) * out;
        EXPECT_TRUE(kinematics::inverse(arm, at, {}, &lack).empty()) << name;
        EXPECT_EQ(lack.axis, 2U) << name;
        EXPECT_NEAR(lack.length, 1, 0.01) << name;
    }
}

TEST(Arm, SingularitiesAreSeenInTheirOwnTerms) {
    const auto irb = industrial(495, 175, 900, 175, 960, 135);
    // wrist: axis 5 at 4 degrees
    const auto wrist = kinematics::nearness(irb, {0.3, 0.2, 0.4, 1, 4 * pi / 180, 2});
    EXPECT_EQ(wrist.which, Singular::wrist);
    EXPECT_NEAR(wrist.angle, 4 * pi / 180, 1e-9);
    EXPECT_NEAR(kinematics::nearness(irb, {0.3, 0.2, 0.4, 1, pi - 0.05, 2}).angle, 0.05, 1e-9);
    // shoulder: the wrist's centre above axis 1, at some height
    const auto over = kinematics::inverse(irb, {geom::about({0, 1, 0}, pi), {0, 1, 1600}}, {});
    ASSERT_FALSE(over.empty());
    for (const auto& q : over) {
        const auto n = kinematics::nearness(irb, q);
        if (n.which != Singular::shoulder) continue;
        EXPECT_NEAR(n.angle, std::asin(1 / irb.reach), 1e-6);
    }
    EXPECT_TRUE(std::ranges::any_of(
        over, [&](const auto& q) { return kinematics::nearness(irb, q).which == Singular::shoulder; }));
    // elbow and wrist of the other build
    EXPECT_NEAR(kinematics::nearness(ur10e(), {0, -1, 0.07, -1, -pi / 2, 0}).angle, 0.07, 1e-9);
    EXPECT_EQ(kinematics::nearness(ur10e(), {0, -1, 0.07, -1, -pi / 2, 0}).which, Singular::elbow);
    EXPECT_NEAR(kinematics::nearness(ur10e(), {0, -1, 1.2, -1, 0.02, 0}).angle, 0.02, 1e-9);
}

TEST(Arm, WhereAnAxisIsFreeItStays) {
    const auto irb = industrial(495, 175, 900, 175, 960, 135);
    const Posture near{0.3, 0.2, 0.4, 1.1, 0, -0.6};
    const auto ways = kinematics::inverse(irb, kinematics::forward(irb, near), near);
    double nearest = 9;
    for (const auto& w : ways) nearest = std::min(nearest, kinematics::apart(kinematics::unwrapped(w, near), near));
    EXPECT_LT(nearest, 1e-6);
}
