// How a part is turned on the machine: the narrowest cone of its tool axes, and the turn that brings it upright.
#include "postproc/turning.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace filum;
using geom::Vec3;

namespace {

constexpr double kPi = std::numbers::pi;

double angle(const Vec3& a, const Vec3& b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }

Vec3 direction(double tilt, double heading) {
    return {std::sin(tilt) * std::cos(heading), std::sin(tilt) * std::sin(heading), std::cos(tilt)};
}

} // namespace

TEST(turning, finds_the_cone_that_axes_were_drawn_from) {
    std::mt19937 engine{3};
    const auto random = [&](double lo, double hi) { return lo + (hi - lo) * (engine() / 4294967296.0); };
    for (int round = 0; round < 50; ++round) {
        const auto turn = postproc::turning({random(-180, 180), random(-90, 90), random(-180, 180)});
        const double half = random(0.02, 1.5);
        std::vector<Vec3> axes;
        for (int k = 0; k < 3; ++k) axes.push_back(turn(direction(half, 2.1 * k + random(-0.2, 0.2)))); // fix the cone
        for (int k = 0; k < 200; ++k) axes.push_back(turn(direction(random(0, half), random(0, 2 * kPi))));
        const auto cone = postproc::narrowest_cone(axes);
        EXPECT_NEAR(cone.half, half, 1e-6);
        EXPECT_LT(angle(cone.axis, turn.z), 1e-6);
        const auto up = postproc::upright(cone.axis);
        for (const Vec3& a : axes) EXPECT_LE(angle(up(a), {0, 0, 1}), half + 1e-5); // angles are said in 1e-4 degrees
    }
}

TEST(turning, of_few_or_opposite_axes) {
    EXPECT_EQ(postproc::narrowest_cone({}).half, 0);
    const std::vector<Vec3> one{{0, 1, 0}, {0, 1, 0}}, two{{1, 0, 0}, {0, 1, 0}}, opposite{{1, 0, 0}, {-1, 0, 0}};
    EXPECT_NEAR(postproc::narrowest_cone(one).half, 0, 1e-12);
    const auto cone = postproc::narrowest_cone(two);
    EXPECT_NEAR(cone.half, kPi / 4, 1e-9);
    EXPECT_LT(angle(cone.axis, {1, 1, 0}), 1e-9);
    EXPECT_GE(postproc::narrowest_cone(opposite).half, kPi / 2);
}

TEST(turning, upright_turns_without_a_spin) {
    for (const Vec3& up : {Vec3{0, 0, 1}, Vec3{0, 0, -3}, Vec3{1, 0, 0}, Vec3{0, -2, 0}, Vec3{1, 2, -0.5}}) {
        const auto t = postproc::upright(up);
        EXPECT_LT(angle(t(up), {0, 0, 1}), 3e-6);
        const double by = angle(up, {0, 0, 1}), trace = t.x.x + t.y.y + t.z.z;
        EXPECT_NEAR(trace, 1 + 2 * std::cos(by), 1e-5); // no more than the way from `up` to z
        EXPECT_NEAR(dot(cross(t.x, t.y), t.z), 1, 1e-12);
    }
    EXPECT_TRUE(postproc::upright({0, 0, 2}).none());
}

TEST(turning, is_read_from_text) {
    EXPECT_TRUE(postproc::parse_orient("auto").automatic);
    EXPECT_TRUE(postproc::parse_orient("as-is").turning.none());
    const auto t = postproc::parse_orient("90,0,90").turning; // x, then z
    EXPECT_LT(distance(t({0, 1, 0}), {0, 0, 1}), 1e-12);
    EXPECT_LT(distance(t({0, 0, 1}), {1, 0, 0}), 1e-12);
    EXPECT_LT(distance(postproc::parse_orient("up:0,1,0").turning({0, 1, 0}), {0, 0, 1}), 1e-6);
    for (const char* wrong : {"", "upright", "1,2", "1,2,3,4", "1,2,x", "nan,0,0", "up:0,0,0", "up:1,2", "inf,0,0"})
        EXPECT_THROW(postproc::parse_orient(wrong), Error) << wrong;
}
