// How a part is turned on the machine: the narrowest cone of its tool axes, and the turn that brings it upright.
#include "postproc/measure.hpp"

#include "base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

using namespace filum;
using geom::Vec3;

namespace {

using std::numbers::pi;

Vec3 direction(double tilt, double heading) {
    return {std::sin(tilt) * std::cos(heading), std::sin(tilt) * std::sin(heading), std::cos(tilt)};
}

// A bead over a cap of radius 60, `half` to both sides of `up`, the tool upright to it.
toolpath::Span cap(const postproc::Turning& lying, double half) {
    toolpath::Span s{toolpath::Role::bead, 0, 0, 0, {}, {1.0}, {0.2}, {}};
    for (int i = 0; i <= 40; ++i) {
        const Vec3 n = lying(direction(half * std::abs(i / 20.0 - 1), i < 20 ? 0 : pi));
        s.points.push_back(60 * n);
        s.normals.push_back(n);
    }
    return s;
}

postproc::FirstPass measured(const toolpath::Span& span, const std::string& orient, const std::string& more = "") {
    const auto p = machine::parse_profile("name = \"test\"\n[bed]\nx = [-300, 300]\ny = [-300, 300]\nz = [-300, 400]\n"
                                          "[extrusion]\nkind = \"filament\"\ndiameter = 1.75\n[kinematics]\n"
                                          "carrier = \"table-table\"\ntilt_deg = [-50, 30]\norientation_deg = 1\n" +
                                              more,
                                          "test.toml");
    postproc::Measure measure(p, postproc::Place::center, postproc::parse_orient(orient));
    do measure.add(span);
    while (measure.again());
    return measure.end();
}

} // namespace

TEST(Turning, BringsAPartWithinTheTiltsOfTheMachine) {
    const auto lying = postproc::turning({70, 30, 10});
    const auto refused = [](const toolpath::Span& span, const std::string& orient,
                            const std::vector<const char*>& words) {
        try {
            measured(span, orient);
            ADD_FAILURE() << orient;
        } catch (const Error& e) {
            EXPECT_EQ(e.exit(), Exit::failure);
            for (const char* word : words) EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    refused(cap(lying, 0.8), "as-is", {"the tilt axis reaches -50 to 30", "--orient auto"});
    const auto first_pass = measured(cap(lying, 0.8), "auto");
    EXPECT_NE(first_pass.placed.find("placed: the toolpath turned by"), std::string::npos);
    EXPECT_EQ(first_pass.efforts.unwinds, 0U);
    EXPECT_NO_THROW(measured(cap(lying, 0.8), "up:" + std::to_string(lying.z.x) + "," + std::to_string(lying.z.y) +
                                                  "," + std::to_string(lying.z.z)));
    // 50 degrees and the lean of one: what is a little beyond leans, what is more is refused with what it would need.
    const auto leaning = measured(cap(lying, 50.6 * pi / 180), "auto");
    EXPECT_NEAR(leaning.efforts.clipped, 0.6 * pi / 180, 1e-5);
    refused(cap(lying, 1.2), "auto", {"tilt by 68.8 degrees", "no way to turn the part needs less"});
    refused(cap(lying, 2.0), "auto", {"no way to turn the part needs less"});
}

TEST(Turning, FindsTheConeThatAxesWereDrawnFrom) {
    std::mt19937 engine{3};
    const auto random = [&](double lo, double hi) { return lo + (hi - lo) * (engine() / 4294967296.0); };
    for (int round = 0; round < 50; ++round) {
        const auto turn = postproc::turning({random(-180, 180), random(-90, 90), random(-180, 180)});
        const double half = random(0.02, 1.5);
        std::vector<Vec3> axes;
        for (int k = 0; k < 3; ++k) axes.push_back(turn(direction(half, 2.1 * k + random(-0.2, 0.2)))); // fix the cone
        for (int k = 0; k < 200; ++k) {
            const double lean = random(0, half), round = random(0, 2 * pi);
            axes.push_back(turn(direction(lean, round)));
        }
        const auto cone = postproc::narrowest_cone(axes);
        EXPECT_NEAR(cone.half, half, 1e-6);
        EXPECT_LT(angle(cone.axis, turn.z), 1e-6);
        const auto up = postproc::upright(cone.axis);
        for (const Vec3& a : axes)
            EXPECT_LE(angle(up(a), {0, 0, 1}), half + 1e-5); // angles are multiples of 1e-4 degrees
    }
}

TEST(Turning, OfFewOrOppositeAxes) {
    EXPECT_EQ(postproc::narrowest_cone({}).half, 0);
    const std::vector<Vec3> one{{0, 1, 0}, {0, 1, 0}}, two{{1, 0, 0}, {0, 1, 0}}, opposite{{1, 0, 0}, {-1, 0, 0}};
    EXPECT_NEAR(postproc::narrowest_cone(one).half, 0, 1e-12);
    const auto cone = postproc::narrowest_cone(two);
    EXPECT_NEAR(cone.half, pi / 4, 1e-9);
    EXPECT_LT(angle(cone.axis, {1, 1, 0}), 1e-9);
    EXPECT_GE(postproc::narrowest_cone(opposite).half, pi / 2);
}

TEST(Turning, UprightTurnsWithoutASpin) {
    for (const Vec3& up : {Vec3{0, 0, 1}, Vec3{0, 0, -3}, Vec3{1, 0, 0}, Vec3{0, -2, 0}, Vec3{1, 2, -0.5}}) {
        const auto t = postproc::upright(up);
        EXPECT_LT(angle(t(up), {0, 0, 1}), 3e-6);
        const double by = angle(up, {0, 0, 1}), trace = t.x.x + t.y.y + t.z.z;
        EXPECT_NEAR(trace, 1 + 2 * std::cos(by), 1e-5); // no more than the way from `up` to z
        EXPECT_NEAR(dot(cross(t.x, t.y), t.z), 1, 1e-12);
    }
    EXPECT_TRUE(postproc::upright({0, 0, 2}).none());
}

TEST(Turning, IsReadFromText) {
    EXPECT_TRUE(postproc::parse_orient("auto").automatic);
    EXPECT_TRUE(postproc::parse_orient("as-is").turning.none());
    const auto t = postproc::parse_orient("90,0,90").turning; // x, then z
    EXPECT_LT(distance(t({0, 1, 0}), {0, 0, 1}), 1e-12);
    EXPECT_LT(distance(t({0, 0, 1}), {1, 0, 0}), 1e-12);
    EXPECT_LT(distance(postproc::parse_orient("up:0,1,0").turning({0, 1, 0}), {0, 0, 1}), 1e-6);
    for (const char* wrong : {"", "upright", "1,2", "1,2,3,4", "1,2,x", "nan,0,0", "up:0,0,0", "up:1,2", "inf,0,0"})
        EXPECT_THROW(postproc::parse_orient(wrong), Error) << wrong;
}
