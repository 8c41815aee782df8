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
TEST(Chain, AgreesWithThePublishedFormOfXyzbc) {
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
TEST(Chain, AgreesWithLinuxcncOnXyzac) {
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

TEST(Chain, ForwardUndoesInverse) {
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

TEST(Chain, TheTipStaysWhereItIsWhenAHeadTilts) {
    const Chain c = machine(Carrier::head_table, {0, 1, 0});
    const Joints upright = place(c, {10, 20, 30}, 0, 0), tilted = place(c, {10, 20, 30}, 0.5, 0);
    EXPECT_EQ(upright.xyz, (Vec3{10, 20, 30}));
    EXPECT_NEAR(tilted.xyz.x - 10, 120 * std::sin(0.5) + 0.5 * (std::cos(0.5) - 1), 1e-9); // the pivot moves out
    EXPECT_LT(distance(forward(c, tilted).tip, {10, 20, 30}), 1e-9);
}

// Over a dome the tool comes near to upright; the turn axis must not spin there, and positions are kept.
TEST(Track, PassesThePoleWithoutASpin) {
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
        for (std::size_t i = 1; i < t.pieces[0].joints.size(); ++i)
            out = std::max(out, std::abs(t.pieces[0].joints[i].turn - t.pieces[0].joints[i - 1].turn));
        return out;
    };
    EXPECT_LT(exact.off, 1e-9);
    EXPECT_GT(most(exact), 0.5);
    EXPECT_LT(most(eased), 0.1);
    EXPECT_LE(eased.off, tolerance * 1.0001);
    for (std::size_t i = 0; i < poses.size(); ++i) {
        EXPECT_LT(distance(forward(c, eased.pieces[0].joints[i]).tip, poses[i].tip), 1e-9);
        const bool far = std::abs(poses[i].tip.x) > 20; // from the pole nothing changes
        EXPECT_LT(angle(forward(c, eased.pieces[0].joints[i]).axis, poses[i].axis), far ? 1e-9 : tolerance * 1.0001);
    }
}

// Round a cone the turn axis goes on and on; limits are met by whole turns or not at all.
TEST(Track, TurnsOnWithoutWrappingUntilItsLimits) {
    const Chain c = machine(Carrier::head_head, {1, 0, 0});
    std::vector<Pose> poses;
    for (int i = 0; i <= 300; ++i) {
        const double a = 2 * kPi * i / 100;
        poses.push_back({{10 * std::cos(a), 10 * std::sin(a), 5},
                         {std::sin(0.4) * std::cos(a), std::sin(0.4) * std::sin(a), std::cos(0.4)}});
    }
    const Track free = track(c, poses, {}, 0.01);
    for (std::size_t i = 1; i < poses.size(); ++i)
        EXPECT_NEAR(std::abs(free.pieces[0].joints[i].turn - free.pieces[0].joints[i - 1].turn), 2 * kPi / 100, 1e-6);
    EXPECT_NEAR(std::abs(free.pieces[0].joints.back().turn - free.pieces[0].joints.front().turn), 6 * kPi, 1e-6);
    EXPECT_EQ(free.stuck, poses.size());
    const Track shifted = track(c, poses, {}, 0.01, {-10, 10, -100, -30});
    EXPECT_EQ(shifted.stuck, poses.size());
    EXPECT_LT(shifted.pieces[0].joints.front().turn, -30);
    const Track stuck = track(c, poses, {}, 0.01, {-10, 10, -2 * kPi, 2 * kPi});
    EXPECT_LT(stuck.stuck, poses.size());
    EXPECT_NE(stuck.why.find("turn"), std::string::npos);
    EXPECT_EQ(track(c, poses, {}, 0.01, {0.5, 1, -100, 100}).stuck, 0U);
}

// Poses round a cone of half angle `tilt`, from heading a to b, one a degree.
std::vector<Pose> cone(double tilt, double a, double b) {
    std::vector<Pose> out;
    const int n = static_cast<int>(std::ceil(std::abs(b - a) * 180 / kPi));
    for (int i = 0; i <= n; ++i) {
        const double h = a + (b - a) * i / n;
        out.push_back({{10 * std::cos(h), 10 * std::sin(h), 5},
                       {std::sin(tilt) * std::cos(h), std::sin(tilt) * std::sin(h), std::cos(tilt)}});
    }
    return out;
}

void expect_within(const Chain& c, const Track& t, const std::vector<Pose>& poses, const Limits& l) {
    ASSERT_EQ(t.stuck, poses.size());
    std::size_t next = 0;
    for (const TrackStretch& piece : t.pieces) {
        EXPECT_EQ(piece.first, next);
        for (std::size_t k = 0; k < piece.joints.size(); ++k) {
            const Joints& j = piece.joints[k];
            EXPECT_TRUE(j.turn >= l.turn_min - 1e-9 && j.turn <= l.turn_max + 1e-9) << j.turn;
            EXPECT_TRUE(j.tilt >= l.tilt_min - 1e-9 && j.tilt <= l.tilt_max + 1e-9) << j.tilt;
            EXPECT_LT(distance(forward(c, j).tip, poses[piece.first + k].tip), 1e-9);
            EXPECT_LT(angle(forward(c, j).axis, poses[piece.first + k].axis), 1e-6);
        }
        next = piece.first + piece.joints.size() - 1;
    }
    EXPECT_EQ(next, poses.size() - 1);
}

// What a greedy choice takes: at each pose the nearest way within the limits; the pose where it can't go on.
std::size_t greedy(const Chain& c, const std::vector<Pose>& poses, Joints at, const Limits& l) {
    for (std::size_t i = 0; i < poses.size(); ++i) {
        double best = 1e9;
        Joints next;
        for (const Joints& j : inverse(c, poses[i])) {
            const double turn = j.turn + 2 * kPi * std::round((at.turn - j.turn) / (2 * kPi));
            const double cost = std::abs(turn - at.turn) + std::abs(j.tilt - at.tilt);
            const bool jumps = i > 0 && std::abs(turn - at.turn) > kPi / 2;
            if (jumps || turn < l.turn_min || turn > l.turn_max || cost >= best) continue;
            best = cost;
            next = place(c, poses[i].tip, j.tilt, turn);
        }
        if (best == 1e9) return i;
        at = next;
    }
    return poses.size();
}

// The nearer way to begin runs into the limit of the turn; the other one, half a turn off, goes through.
TEST(Track, LooksAheadOverTheWholeStroke) {
    const Chain c = machine(Carrier::table_table, {0, 1, 0});
    const auto poses = cone(0.6, 0.2, 0.2 + 1.5 * kPi);
    const Limits limits{-2, 2, -4, 4};
    const std::vector<Lifting> lifting(poses.size(), Lifting::bead);
    std::vector<Lifting> from_air = lifting;
    from_air[0] = Lifting::air;
    const Joints before = inverse(c, poses[0])[0];
    EXPECT_LT(greedy(c, poses, before, limits), poses.size());
    const Track t = track(c, poses, before, 1e-6, limits, from_air);
    EXPECT_EQ(t.pieces.size(), 1U);
    expect_within(c, t, poses, limits);
}

// Turning back gains whole turns: two on an axis of a little more than two.  So one break serves three turns, and a
// free axis needs none.
TEST(Track, LiftsAsSeldomAsItCan) {
    const Chain c = machine(Carrier::head_table, {0, 1, 0});
    const auto poses = cone(0.5, 0, 6.5 * kPi);
    std::vector<Lifting> lifting(poses.size(), Lifting::bead);
    lifting[0] = Lifting::air;
    const Limits limits{-0.1, 2, -2.25 * kPi, 2.25 * kPi};
    const Track t = track(c, poses, {}, 1e-6, limits, lifting);
    EXPECT_EQ(t.pieces.size(), 2U);
    expect_within(c, t, poses, limits);
    EXPECT_EQ(track(c, poses, {}, 1e-6, {-0.1, 2}, lifting).pieces.size(), 1U);
}

// A break goes where it shows least: into a join if there is one, never into a tight turn if that can be had.
TEST(Track, LiftsWhereItShowsLeast) {
    const Chain c = machine(Carrier::table_table, {1, 0, 0});
    const auto poses = cone(0.5, 0, 2.5 * kPi);
    const Limits limits{-1, 0.1, -1.25 * kPi, 1.25 * kPi};
    std::vector<Lifting> lifting(poses.size(), Lifting::turn);
    lifting[0] = Lifting::air;
    lifting[100] = Lifting::bead;
    auto t = track(c, poses, {}, 1e-6, limits, lifting);
    ASSERT_EQ(t.pieces.size(), 2U);
    EXPECT_EQ(t.pieces[1].first, 100U);
    expect_within(c, t, poses, limits);
    lifting[90] = Lifting::join;
    t = track(c, poses, {}, 1e-6, limits, lifting);
    ASSERT_EQ(t.pieces.size(), 2U);
    EXPECT_EQ(t.pieces[1].first, 90U);
}

// Of both ways that one is taken whose tilts the machine has, all along; an axis a little out of reach leans.
TEST(Track, KeepsTheLimitsOfTheTilt) {
    const Chain c = machine(Carrier::table_table, {1, 0, 0});
    const auto poses = cone(1.0, 0, 2);
    const std::vector<Lifting> lifting(poses.size(), Lifting::bead);
    for (const Limits& l : {Limits{-0.2, 1.1}, Limits{-1.1, 0.2}})
        expect_within(c, track(c, poses, {}, 0.03, l), poses, l);
    const Track leaning = track(c, poses, {}, 0.03, {-0.2, 0.98}, lifting);
    EXPECT_EQ(leaning.stuck, poses.size());
    EXPECT_NEAR(leaning.clipped, 0.02, 1e-9);
    EXPECT_NEAR(leaning.off, 0.02, 1e-6);
    for (const Joints& j : leaning.pieces[0].joints) EXPECT_LE(j.tilt, 0.98);
    EXPECT_EQ(track(c, poses, {}, 0.03, {-0.2, 0.9}, lifting).stuck, 0U);
}

// x is the radius: the tip lies on the machine's x-z plane, positions are kept, the axis as far as it lies radially.
TEST(Chain, PolarHasNoY) {
    Chain c = machine(Carrier::polar, {0, 1, 0});
    Random random;
    for (const double sign : {1.0, -1.0})
        for (int i = 0; i < 100; ++i) {
            c.turn_sign = sign;
            const Vec3 tip{random(-50, 50), random(-50, 50), random(0, 50)};
            const geom::Vec2 d = tip.xy() - c.turn_point.xy();
            const double out = random(-1, 1); // lean of the axis, outwards
            const Vec3 axis{std::sin(out) * d.x / norm(d), std::sin(out) * d.y / norm(d), std::cos(out)};
            const auto both = inverse(c, {tip, axis});
            for (const Joints& j : both) {
                EXPECT_NEAR(j.xyz.y, c.turn_point.y, 1e-9);
                EXPECT_LT(distance(forward(c, j).tip, tip), 1e-9);
                EXPECT_LT(angle(forward(c, j).axis, axis), 1e-9);
            }
            const double swing = c.tip_to_tilt.x * (1 - std::cos(out)) - c.tip_to_tilt.z * std::sin(out);
            EXPECT_NEAR(both[0].xyz.x, c.turn_point.x + norm(d) - swing, 1e-9);
        }
}

// Random lines past the turn axis, some through it: the axes keep the tip on its line up to both ends of every move.
TEST(Track, PolarMovesBeginAndEndWhereTheirLinesDo) {
    const Chain c = machine(Carrier::polar, {0, 1, 0});
    Random random;
    const Vec3 centre{c.turn_point.x, c.turn_point.y, 0};
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Pose> poses;
        for (int k = 0; k < 30; ++k) {
            const double far = k % 3 == 0 ? 0.5 : 10;
            poses.push_back({centre + Vec3{random(-far, far), random(-far, far), 0}});
            if (k % 7 == 0) { // the tip turns on the spot
                poses.push_back({centre});
                poses.push_back({centre});
            }
        }
        const Track t = track(c, poses, {}, 0.5);
        ASSERT_EQ(t.stuck, poses.size());
        const auto& joints = t.pieces[0].joints;
        for (std::size_t i = 1; i < joints.size(); ++i) {
            if (distance(poses[i - 1].tip, poses[i].tip) == 0) continue;
            const auto at = [&](double f) {
                return between(c, poses[i - 1].tip, joints[i - 1], poses[i].tip, joints[i], f);
            };
            for (const double f : {1e-7, 1 - 1e-7}) {
                const Joints& end = joints[f < 0.5 ? i - 1 : i];
                EXPECT_NEAR(at(f).turn, end.turn, 1e-3) << trial << ' ' << i;
                EXPECT_NEAR(at(f).xyz.x, end.xyz.x, 1e-3) << trial << ' ' << i;
            }
        }
    }
}

} // namespace
} // namespace filum::kinematics
