// Machines with two rotary axes against published closed forms, and forward against inverse.
#include "kinematics/track.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace filum::kinematics {
namespace {

constexpr double kPi = std::numbers::pi;

Chain machine(Carrier carrier, Vec3 tilt_axis) {
    Chain c;
    c.carrier = carrier;
    c.tilt_axis = tilt_axis;
    c.turn_point = {3, -4, 0};
    c.tilt_point = {3, -2, -35};
    c.tip_to_tilt = {0.5, -1, 120};
    c.tilt_to_turn = {4, 2, 30};
    return c;
}

struct Random {
    std::mt19937 engine{7};
    double operator()(double lo, double hi) { return lo + (hi - lo) * static_cast<double>(engine()) / 4294967296.0; }
    Vec3 axis(double most) {
        const double tilt = (*this)(0, most), turn = (*this)(-kPi, kPi);
        return {std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
    }
};

// X = cosB cosC x - cosB sinC y + sinB z, Y = sinC x + cosC y, Z = -sinB cosC x + sinB sinC y + cosB z, with
// B = -acos nz, C = -atan2(ny, nx) or B = acos nz, C + pi (Zhang et al. 2021, table-table XYZBC).
TEST(chain, agrees_with_the_published_form_of_xyzbc) {
    Chain c;
    c.carrier = Carrier::table_table;
    Random random;
    for (int i = 0; i < 200; ++i) {
        const Pose pose{{random(-50, 50), random(-50, 50), random(0, 50)}, random.axis(1.5)};
        const auto both = inverse(c, pose);
        bool first = false, second = false;
        for (const Joints& j : both) {
            const double b = j.tilt, t = j.turn;
            const Vec3& p = pose.tip;
            EXPECT_NEAR(j.xyz.x, std::cos(b) * std::cos(t) * p.x - std::cos(b) * std::sin(t) * p.y + std::sin(b) * p.z,
                        1e-9);
            EXPECT_NEAR(j.xyz.y, std::sin(t) * p.x + std::cos(t) * p.y, 1e-9);
            EXPECT_NEAR(j.xyz.z, -std::sin(b) * std::cos(t) * p.x + std::sin(b) * std::sin(t) * p.y + std::cos(b) * p.z,
                        1e-9);
            const double tilt = std::acos(pose.axis.z), turn = -std::atan2(pose.axis.y, pose.axis.x);
            first = first || (std::abs(b + tilt) < 1e-9 && std::abs(std::remainder(t - turn, 2 * kPi)) < 1e-9);
            second = second || (std::abs(b - tilt) < 1e-9 && std::abs(std::remainder(t - turn - kPi, 2 * kPi)) < 1e-9);
        }
        EXPECT_TRUE(first && second);
    }
}

// LinuxCNC's trtfuncs.c, xyzac: Y = cosA (sinC x + cosC y) - sinA z - cosA dy + sinA dz + dy and so on.
TEST(chain, agrees_with_linuxcnc_on_xyzac) {
    Chain c;
    c.carrier = Carrier::table_table;
    c.tilt_axis = {1, 0, 0};
    const double dy = 5, dz = -20;
    c.tilt_point = {0, dy, dz};
    Random random;
    for (int i = 0; i < 100; ++i) {
        const Vec3 p{random(-50, 50), random(-50, 50), random(0, 50)};
        const double a = random(-1, 1), t = random(-4, 4);
        const Joints j = place(c, p, a, t);
        const double y = std::sin(t) * p.x + std::cos(t) * p.y;
        EXPECT_NEAR(j.xyz.x, std::cos(t) * p.x - std::sin(t) * p.y, 1e-9);
        EXPECT_NEAR(j.xyz.y, std::cos(a) * y - std::sin(a) * p.z - std::cos(a) * dy + std::sin(a) * dz + dy, 1e-9);
        EXPECT_NEAR(j.xyz.z, std::sin(a) * y + std::cos(a) * p.z - std::sin(a) * dy - std::cos(a) * dz + dz, 1e-9);
    }
}

TEST(chain, forward_undoes_inverse) {
    Random random;
    for (const Carrier carrier : {Carrier::table_table, Carrier::head_table, Carrier::head_head})
        for (const Vec3 tilt : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}})
            for (const double sign : {1.0, -1.0})
                for (int i = 0; i < 50; ++i) {
                    Chain c = machine(carrier, tilt);
                    c.turn_sign = sign;
                    const Pose pose{{random(-50, 50), random(-50, 50), random(-50, 50)}, random.axis(3)};
                    for (const Joints& j : inverse(c, pose)) {
                        const Pose back = forward(c, j);
                        EXPECT_LT(distance(back.tip, pose.tip), 1e-9);
                        EXPECT_LT(angle(back.axis, pose.axis), 1e-7);
                        EXPECT_NEAR(std::remainder(best_tilt(c, pose.axis, j.turn) - j.tilt, 2 * kPi), 0, 1e-7);
                    }
                }
}

TEST(chain, the_tip_stays_where_it_is_when_a_head_tilts) {
    const Chain c = machine(Carrier::head_table, {0, 1, 0});
    const Joints upright = place(c, {10, 20, 30}, 0, 0), tilted = place(c, {10, 20, 30}, 0.5, 0);
    EXPECT_EQ(upright.xyz, (Vec3{10, 20, 30}));
    EXPECT_NEAR(tilted.xyz.x - 10, 120 * std::sin(0.5) + 0.5 * (std::cos(0.5) - 1), 1e-9); // the pivot moves out
    EXPECT_LT(distance(forward(c, tilted).tip, {10, 20, 30}), 1e-9);
}

// Over a dome the tool comes near to upright; the turn axis must not spin there, and positions are kept.
TEST(track, passes_the_pole_without_a_spin) {
    const Chain c = machine(Carrier::table_table, {0, 1, 0});
    std::vector<Pose> poses;
    for (int i = -100; i <= 100; ++i) {
        const double x = 0.3 * i, y = 0.2, r = 60, z = std::sqrt(r * r - x * x - y * y);
        poses.push_back({{x, y, z}, {x / r, y / r, z / r}});
    }
    const double tolerance = 2 * kPi / 180;
    const Track exact = track(c, poses, {}, 0), eased = track(c, poses, {}, tolerance);
    const auto most = [](const Track& t) {
        double out = 0;
        for (std::size_t i = 1; i < t.joints.size(); ++i)
            out = std::max(out, std::abs(t.joints[i].turn - t.joints[i - 1].turn));
        return out;
    };
    EXPECT_LT(exact.off, 1e-9);
    EXPECT_GT(most(exact), 0.5);
    EXPECT_LT(most(eased), 0.1);
    EXPECT_LE(eased.off, tolerance * 1.0001);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        EXPECT_LT(distance(forward(c, eased.joints[i]).tip, poses[i].tip), 1e-9);
        const bool far = std::abs(poses[i].tip.x) > 20; // from the pole nothing changes
        EXPECT_LT(angle(forward(c, eased.joints[i]).axis, poses[i].axis), far ? 1e-9 : tolerance * 1.0001);
    }
}

// Round a cone the turn axis goes on and on; limits are met by whole turns or not at all.
TEST(track, turns_on_without_wrapping_until_its_limits) {
    const Chain c = machine(Carrier::head_head, {1, 0, 0});
    std::vector<Pose> poses;
    for (int i = 0; i <= 300; ++i) {
        const double a = 2 * kPi * i / 100;
        poses.push_back({{10 * std::cos(a), 10 * std::sin(a), 5},
                         {std::sin(0.4) * std::cos(a), std::sin(0.4) * std::sin(a), std::cos(0.4)}});
    }
    const Track free = track(c, poses, {}, 0.01);
    for (std::size_t i = 1; i < poses.size(); ++i)
        EXPECT_NEAR(std::abs(free.joints[i].turn - free.joints[i - 1].turn), 2 * kPi / 100, 1e-6);
    EXPECT_NEAR(std::abs(free.joints.back().turn - free.joints.front().turn), 6 * kPi, 1e-6);
    EXPECT_EQ(free.stuck, poses.size());
    const Track shifted = track(c, poses, {}, 0.01, {-10, 10, -100, -30});
    EXPECT_EQ(shifted.stuck, poses.size());
    EXPECT_LT(shifted.joints.front().turn, -30);
    const Track stuck = track(c, poses, {}, 0.01, {-10, 10, -2 * kPi, 2 * kPi});
    EXPECT_LT(stuck.stuck, poses.size());
    EXPECT_NE(stuck.why.find("turn"), std::string::npos);
    EXPECT_EQ(track(c, poses, {}, 0.01, {0.5, 1, -100, 100}).stuck, 0U);
}

} // namespace
} // namespace filum::kinematics
