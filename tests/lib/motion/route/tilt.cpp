#include "route/tilt.hpp"

#include "geom/angle.hpp"

#include <gtest/gtest.h>

namespace {

using namespace filum;
using namespace filum::route;
using collision::Options;
using collision::Room;
using collision::Scene;
using collision::Shape;
using collision::Solid;
using collision::Tree;
using toolpath::Role;
using toolpath::Span;

using geom::kDegree;
constexpr double kAway = 3, kHigh = 20, kFlat = 0.2, kHalf = 15 * kDegree; // of the wall, and the cone

// An upright wall in the plane x = kAway, from y0 to y1.
Scene wall(double y0, double y1) {
    const Solid s{{Vec3{kAway, y0, -5}, {kAway, y1, -5}, {kAway, y1, kHigh}, {kAway, y0, kHigh}}, 0, 0};
    return {Tree({}), Tree({s}), Tree({}), Tree({})};
}

machine::Head cone() {
    machine::Head head;
    head.flat_radius = kFlat;
    head.cone_angle = 2 * kHalf;
    head.cone_height = 100;
    head.carriage_x = head.carriage_y = 0;
    return head;
}

// The least lean away from the wall: its top edge, seen from the flat's near rim, on the side of the cone.
double least_lean() {
    double low = 0, high = kHalf;
    while (high - low > 1e-9) {
        const double t = (low + high) / 2;
        // the edge in the head's frame: x away from the wall's side, z up the tool, which leans to -x
        const double x = kAway * std::cos(t) + kHigh * std::sin(t), z = kHigh * std::cos(t) - kAway * std::sin(t);
        ((x - kFlat) * std::cos(kHalf) - z * std::sin(kHalf) > 0 ? high : low) = t;
    }
    return high;
}

Span line(double y0, double y1, std::size_t parts) {
    Span s{Role::bead, 3, 2, 1, {}, {0.4, 0.4}, {0.2}, {}};
    s.width.assign(parts + 1, 0.4);
    for (std::size_t i = 0; i <= parts; ++i)
        s.points.push_back({0, y0 + (y1 - y0) * static_cast<double>(i) / static_cast<double>(parts), 0});
    return s;
}

struct Leans {
    std::vector<Span> spans;
    Scene scene;
    TiltedStroke tilted;
    Leans(std::vector<Span> s, Scene w, const TiltOptions& o, const std::vector<bool>& blocked)
        : spans(std::move(s)), scene(std::move(w)) {
        const Shape shape(cone());
        const Options options;
        Stroke stroke{spans, {}, {}};
        for (const Span& span : spans) {
            stroke.before.emplace_back(span.points.size() - 1, 0);
            stroke.blocked.push_back(blocked);
        }
        tilted = lean(Room(scene, shape, options), stroke, o, {}, 1);
    }
};

TEST(Tilt, TheLeastThatPassesAWall) {
    const Leans run({line(-20, 20, 1)}, wall(-500, 500), {30 * kDegree, 5 * kDegree}, {true});
    const double want = least_lean();
    ASSERT_GT(want, 6 * kDegree);
    const Span& got = run.tilted.spans[0];
    EXPECT_EQ(got.points.size(), 41U);
    for (const Vec3& n : got.normals) {
        EXPECT_NEAR(norm(n), 1, 1e-12);
        EXPECT_NEAR(n.y, 0, 1e-9);
        EXPECT_GE(std::asin(-n.x), want - 1e-6);
        EXPECT_LE(std::asin(-n.x), want + 0.35 * kDegree);
    }
    EXPECT_NEAR(run.tilted.leaning.length, 40, 1e-9);
    EXPECT_NEAR(run.tilted.leaning.leaning, 40, 1e-9);
    EXPECT_GE(run.tilted.leaning.most, want - 1e-6);
    EXPECT_EQ(run.tilted.leaning.stroke, 3U);
    // the places are on the line, widths and heights stay
    for (const Vec3& p : got.points) EXPECT_EQ(p.x, 0);
    for (std::size_t i = 0; i < got.points.size(); ++i) EXPECT_DOUBLE_EQ(got.width_at(i) * got.height_at(i), 0.08);
}

TEST(Tilt, FadesOutNoFasterThanItMay) {
    std::vector<bool> blocked(120, false);
    for (std::size_t i = 45; i < 75; ++i) blocked[i] = true;
    for (const double rate : {1.0, 5.0}) {
        const Leans run({line(-60, 60, 120)}, wall(-10, 10), {20 * kDegree, rate * kDegree}, blocked);
        const Span& got = run.tilted.spans[0];
        ASSERT_EQ(got.points.size(), 121U);
        ASSERT_EQ(got.normals.size(), 121U);
        EXPECT_EQ(got.normals.front(), (Vec3{0, 0, 1}));
        EXPECT_EQ(got.normals.back(), (Vec3{0, 0, 1}));
        EXPECT_GE(std::asin(-got.normals[60].x), least_lean() - 1e-6);
        for (std::size_t i = 1; i < got.normals.size(); ++i) {
            const double turn =
                std::atan2(norm(cross(got.normals[i - 1], got.normals[i])), dot(got.normals[i - 1], got.normals[i]));
            EXPECT_LE(turn, rate * kDegree * 1.0001) << rate << " " << i;
        }
    }
}

// On a slope the tilt is off its normal, and away from a wall that leans, too.
TEST(Tilt, NothingIfNoTiltIsEnough) {
    const Leans run({line(-20, 20, 4)}, wall(-500, 500), {3 * kDegree, 5 * kDegree}, {true, true, true, true});
    EXPECT_EQ(run.tilted.spans[0].points.size(), 5U);
    EXPECT_TRUE(run.tilted.spans[0].normals.empty());
    EXPECT_EQ(run.tilted.leaning.leaning, 0);
    EXPECT_EQ(run.tilted.stuck[0], (std::vector<bool>{true, true, true, true}));
}

TEST(Tilt, SpansOfAStrokeGoOnFromEachOther) {
    Span second = line(0, 20, 2);
    second.role = Role::hairpin;
    const Leans run({line(-20, 0, 2), second}, wall(-500, 500), {30 * kDegree, 5 * kDegree}, {true, true});
    ASSERT_EQ(run.tilted.spans.size(), 2U);
    EXPECT_EQ(run.tilted.spans[0].normals.back(), run.tilted.spans[1].normals.front());
    EXPECT_EQ(run.tilted.spans[1].role, Role::hairpin);
    EXPECT_EQ(run.tilted.origin[0].size(), run.tilted.spans[0].points.size() - 1);
    EXPECT_EQ(run.tilted.origin[0].front(), 0U);
    EXPECT_EQ(run.tilted.origin[0].back(), 1U);
}

} // namespace
