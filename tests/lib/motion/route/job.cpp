#include "route/job.hpp"

#include "route/rim.hpp"

#include <gtest/gtest.h>

namespace {

using namespace filum;
using namespace filum::route;
using collision::Solid;
using toolpath::Role;
using toolpath::Span;

constexpr double kLayer = 0.2;

Span line(std::uint32_t stroke, const Vec3& a, const Vec3& b) {
    return {Role::bead, stroke, 0, 0, {a, b}, {0.4}, {kLayer}, {}};
}
Span hop(std::uint32_t stroke, const Vec3& a, const Vec3& b) {
    return {Role::travel, stroke, 0, 0, {a, b}, {}, {}, {}};
}

// A wall of beads along y at x = 0, as one stroke.
std::vector<Span> tower(std::uint32_t layers) {
    std::vector<Span> out;
    for (std::uint32_t i = 0; i < layers; ++i) {
        const double z = (i + 1) * kLayer, y = i % 2 == 0 ? -5 : 5;
        out.push_back(line(0, {0, y, z}, {0, -y, z}));
        if (i + 1 < layers)
            out.push_back({Role::lift, 0, i, 0, {{0, -y, z}, {0, -y, z + kLayer}}, {0.4}, {kLayer}, {}});
    }
    return out;
}

// A stroke on either side of the tower, after it.
std::vector<Span> both_sides(std::uint32_t layers) {
    auto spans = tower(layers);
    const Vec3 end = spans.back().points.back(), a{-8, -5, kLayer}, b{-8, 5, kLayer}, c{8, 5, kLayer}, d{8, -5, kLayer};
    spans.push_back(hop(1, end, a));
    spans.push_back(line(1, a, b));
    spans.push_back(hop(2, b, {0, 7, kLayer}));
    spans.push_back(hop(2, {0, 7, kLayer}, c));
    spans.push_back(line(2, c, d));
    return spans;
}

Options options() {
    Options o;
    o.machine.head.common.cone_height = 20;
    o.machine.head.common.carriage_x = o.machine.head.common.carriage_y = 4;
    o.travel.lift = 0.6;
    return o;
}

TEST(RoutedToolpath, GoesInAndOutBesideThePart) {
    auto spans = both_sides(25);
    const auto given = spans;
    add_rim_ways(spans, options().machine.head, 1);
    ASSERT_EQ(spans.size(), given.size() + 2);
    const Span &in = spans.front(), &out = spans.back();
    EXPECT_EQ(in.points.back(), given.front().points.front());
    EXPECT_EQ(out.points.front(), given.back().points.back());
    for (const Vec3& p : {in.points[0], in.points[1], out.points.back()}) {
        const bool outside = std::abs(p.x) > 8 + 0.2 + 1 || std::abs(p.y) > 5 + 0.2 + 1;
        EXPECT_TRUE(outside) << p.x << "," << p.y;
    }
    const RoutedToolpath job = route::route(spans, {}, options(), 1);
    EXPECT_TRUE(job.found.collisions.empty());
    EXPECT_EQ(job.spans.back().points.back(), out.points.back());
    std::vector<Span> none;
    add_rim_ways(none, options().machine.head, 1);
    EXPECT_TRUE(none.empty());
}

TEST(RoutedToolpath, TravelsOverWhatIsPrinted) {
    const auto given = both_sides(25); // 5 mm
    const RoutedToolpath job = route::route(given, {}, options(), 1);
    EXPECT_TRUE(job.found.collisions.empty());
    ASSERT_EQ(job.spans.size(), given.size() - 1); // two travels became one
    EXPECT_EQ(job.kinds[0] + job.kinds[1] + job.kinds[2], 2U);
    EXPECT_LT(job.after, job.before);
    for (std::size_t i = 0, k = 0; i < given.size(); ++i) {
        if (given[i].role == Role::travel) continue;
        while (job.spans[k].role == Role::travel) ++k;
        EXPECT_EQ(job.spans[k].points, given[i].points);
        EXPECT_TRUE(job.spans[k].normals.empty());
        ++k;
    }
    for (std::size_t i = 0; i < job.spans.size(); ++i) {
        const Span& s = job.spans[i];
        if (s.role != Role::travel) continue;
        EXPECT_EQ(s.normals.size(), s.points.size());
        EXPECT_EQ(s.points.front(), job.spans[i - 1].points.back());
        EXPECT_EQ(s.points.back(), job.spans[i + 1].points.front());
        for (const Vec3& n : s.normals) EXPECT_EQ(n, (Vec3{0, 0, 1}));
    }
    const RoutedToolpath again = route::route(given, {}, options(), 8);
    for (std::size_t i = 0; i < job.spans.size(); ++i) EXPECT_EQ(again.spans[i].points, job.spans[i].points);
}

// The carriage of three axes stands square to the part, and that is known on a routed travel, too: 20 mm to the wall at
// its nearest, where the round column about it would be in it.
TEST(RoutedToolpath, ACarriageThatIsKnownStaysKnown) {
    std::vector<Span> spans{line(0, {0, 0, kLayer}, {0, 10, kLayer}), hop(1, {0, 10, kLayer}, {0, 30, kLayer}),
                            line(1, {0, 30, kLayer}, {0, 40, kLayer})};
    const Solid wall{{Vec3{22, -50, 0}, {22, 90, 0}, {22, 90, 60}, {22, -50, 60}}, 0, 0};
    Options o;
    o.machine.head.common.cone_angle = 0.3;
    const RoutedToolpath job = route::route(spans, {{{}, {wall}, {}, {}}}, o, 1);
    EXPECT_TRUE(job.found.collisions.empty());
    EXPECT_EQ(job.kinds[0], 1U);
    ASSERT_TRUE(job.found.least[1]);
    EXPECT_NEAR(job.found.least[1]->clearance, 2, 1e-6);
    o.machine.rotary = true;
    EXPECT_FALSE(route::route(spans, {{{}, {wall}, {}, {}}}, o, 1).found.collisions.empty());
}

TEST(RoutedToolpath, TheToolLeansAwayFromAWall) {
    std::vector<Span> spans{line(0, {0, 0, kLayer}, {0, 30, kLayer}), hop(1, {0, 30, kLayer}, {-30, 30, kLayer}),
                            line(1, {-30, 30, kLayer}, {-30, 0, kLayer})};
    const Solid wall{{Vec3{3, -9, 0}, {3, 60, 0}, {3, 60, 20}, {3, -9, 20}}, 0, 0};
    Options o;
    o.machine.head.common.cone_angle = 0.5;
    o.machine.head.common.cone_height = 60;
    o.machine.head.common.carriage_x = o.machine.head.common.carriage_y = 0;
    EXPECT_FALSE(route::route(spans, {{{}, {wall}, {}, {}}}, o, 1).found.collisions.empty());
    o.tilt = {0.4, 0.1};
    const RoutedToolpath job = route::route(spans, {{{}, {wall}, {}, {}}}, o, 1);
    EXPECT_TRUE(job.found.collisions.empty());
    ASSERT_EQ(job.leaning.size(), 1U);
    EXPECT_NEAR(job.leaning[0].leaning, 30, 1e-9);
    EXPECT_TRUE(job.spans[2].normals.empty());
    // the travel leaves along the axis that leans
    const Vec3 up = job.spans[1].points[1] - job.spans[1].points[0];
    EXPECT_LT(norm(cross(up, job.spans[0].normals.back())), 1e-9);
    EXPECT_LT(up.x, -0.05);
}

TEST(RoutedToolpath, NothingToDoAndNothingAtAll) {
    EXPECT_TRUE(route::route({}, {}, options(), 1).spans.empty());
    const std::vector<Span> one{hop(0, {9, 9, 9}, {0, 0, kLayer}), line(0, {0, 0, kLayer}, {0, 30, kLayer})};
    const RoutedToolpath job = route::route(one, {}, options(), 1);
    ASSERT_EQ(job.spans.size(), 2U);
    EXPECT_EQ(job.spans[0].points, one[0].points);
    EXPECT_TRUE(job.spans[0].normals.empty());
    // the last travel has no stroke behind it
    auto park = one;
    park.push_back(hop(1, {0, 30, kLayer}, {50, 50, 20}));
    EXPECT_EQ(route::route(park, {}, options(), 1).spans.back().points.back(), (Vec3{50, 50, 20}));
}

} // namespace
