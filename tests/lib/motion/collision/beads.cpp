#include "collision/beads.hpp"

#include <gtest/gtest.h>

namespace {

using namespace filum;
using namespace filum::collision;
using toolpath::Role;
using toolpath::Span;

constexpr double kLayer = 0.2;

Span line(std::uint32_t layer, const Vec3& a, const Vec3& b) {
    return {Role::bead, 0, layer, 0, {a, b}, {0.4}, {kLayer}, {}};
}
Span hop(const Vec3& a, const Vec3& b) { return {Role::travel, 0, 0, 0, {a, b}, {}, {}, {}}; }

// A wall of beads along y at x = 0, `layers` high, joined by lifts.
std::vector<Span> tower(std::uint32_t layers) {
    std::vector<Span> out;
    for (std::uint32_t i = 0; i < layers; ++i) {
        const double z = (i + 1) * kLayer, y = i % 2 == 0 ? -5 : 5;
        out.push_back(line(i, {0, y, z}, {0, -y, z}));
        if (i + 1 < layers)
            out.push_back({Role::lift, 0, i, 0, {{0, -y, z}, {0, -y, z + kLayer}}, {0.4}, {kLayer}, {}});
    }
    return out;
}

CheckResult run(const std::vector<Span>& spans, std::vector<Move>& moves, const machine::Head& head = {}) {
    MoveReader walk(Machine{head});
    for (const Span& s : spans) walk.add(s);
    moves = walk.growth.moves;
    const Scene s{Tree(walk.growth.beads), Tree({}), Tree({}), Tree({})};
    return check(s, head, moves, {}, 1);
}

TEST(BeadGrowth, ABeadBesideATallOne) {
    auto spans = tower(30); // 6 mm
    const Vec3 end = spans.back().points.back(), aside{5, -5, kLayer};
    spans.push_back(hop(end, aside));
    spans.push_back(line(0, aside, {5, 5, kLayer}));
    std::vector<Move> moves;
    const CheckResult free = run(spans, moves);
    EXPECT_EQ(free.moves, 0U);
    // the beads' edge: x 0.2 at half the height of the top one, rounded by 0.1; 5.7 above the tip
    const double across = 5 - 0.1 - (0.2 + 5.7 * std::tan(std::acos(-1) / 6));
    ASSERT_TRUE(free.least[0]);
    EXPECT_NEAR(free.least[0]->clearance, across * std::cos(std::acos(-1) / 6) - 0.1, 1e-6);
    EXPECT_EQ(moves[free.least[0]->move].from.tip, aside);

    machine::Head fat;
    fat.cone_height = 5; // the carriage at 5.2 would be in the wall
    const CheckResult hit = run(spans, moves, fat);
    ASSERT_FALSE(hit.collisions.empty());
    EXPECT_EQ(hit.collisions[0].piece, HeadPiece::carriage);
    EXPECT_TRUE(moves[hit.collisions[0].move].travel); // on the way down

    // the other way round there is nothing to meet
    std::vector<Span> first{line(0, aside, {5, 5, kLayer}), hop({5, 5, kLayer}, {0, -5, kLayer})};
    for (const Span& s : tower(30)) first.push_back(s);
    const CheckResult reversed = run(first, moves, fat);
    EXPECT_EQ(reversed.moves, 0U);
    EXPECT_FALSE(reversed.least[0]);
}

TEST(BeadGrowth, TheFreshBeadDoesNotCount) {
    // Down a slope of 45 degrees with an upright tool: the flat runs into its own bead, which it has just shaped.
    Span down{Role::bead, 0, 0, 0, {}, {0.4}, {kLayer}, {}};
    for (int i = 0; i <= 60; ++i) down.points.push_back({0.1 * i, 0, 10 - 0.1 * i}); // not as deep as the cone is high
    std::vector<Move> moves;
    EXPECT_EQ(run({down}, moves).moves, 0U);
    // Back and up again beside it, less than the cone is wide.
    Span beside = down;
    std::reverse(beside.points.begin(), beside.points.end());
    for (Vec3& p : beside.points) p.y = 0.2;
    std::vector<Move> more;
    EXPECT_GT(run({down, hop(down.points.back(), beside.points.front()), beside}, more).moves, 30U);
}

TEST(BeadGrowth, TravelsRiseUnlessTheyAreShort) {
    MoveReader walk(Machine{{}, 0.6, 2, false});
    walk.add(hop({9, 9, 9}, {0, 0, 0.2})); // there is nothing to leave
    EXPECT_TRUE(walk.growth.moves.empty());
    walk.add(line(0, {0, 0, 3}, {10, 0, 3}));
    walk.add(hop({10, 0, 3}, {10, 1, 3}));
    ASSERT_EQ(walk.growth.moves.size(), 2U);
    EXPECT_EQ(walk.growth.moves[1].to.tip.z, 3);
    walk.add(line(0, {10, 1, 3}, {0, 1, 3}));
    walk.add(hop({0, 1, 3}, {0, 9, 1}));
    ASSERT_EQ(walk.growth.moves.size(), 6U);
    EXPECT_EQ(walk.growth.moves[3].to.tip, (Vec3{0, 1, 3.6}));
    EXPECT_EQ(walk.growth.moves[4].to.tip, (Vec3{0, 9, 3.6}));
    EXPECT_EQ(walk.growth.moves[5].to.tip, (Vec3{0, 9, 1}));
    EXPECT_TRUE(walk.growth.moves[5].travel);
}

TEST(BeadGrowth, AnAxisThatChangesTurnsWhereItStands) {
    MoveReader walk(Machine{{}, 0.6, 0, false});
    Span a = line(0, {0, 0, 1}, {5, 0, 1}), b = line(0, {5, 0, 1}, {9, 0, 1});
    b.normals = {{0.6, 0, 0.8}, {0.6, 0, 0.8}};
    walk.add(a);
    walk.add(b);
    ASSERT_EQ(walk.growth.moves.size(), 3U);
    EXPECT_EQ(walk.growth.moves[1].from.tip, walk.growth.moves[1].to.tip);
    EXPECT_EQ(walk.growth.moves[1].to.axis, (Vec3{0.6, 0, 0.8}));
    EXPECT_EQ(walk.growth.beads.size(), 2U); // turning lays nothing
    // the carriage's direction is unknown once the tool leans
    EXPECT_EQ(walk.growth.moves[0].from.side, (Vec3{1, 0, 0}));
    EXPECT_EQ(walk.growth.moves[1].from.side, Vec3{});
}

TEST(Bead, IsAsWideAndHighAsItSays) {
    const Solid s = bead({{0, 0, 1}}, {{10, 0, 1}}, 2, 0.5, 3);
    EXPECT_EQ(s.radius, 0.25);
    EXPECT_EQ(s.born, 3U);
    for (const Vec3& p : s.corner) {
        EXPECT_DOUBLE_EQ(p.z, 0.75);
        EXPECT_DOUBLE_EQ(std::abs(p.y), 0.75);
    }
    const Solid up = bead({{0, 0, 1}}, {{0, 0, 2}}, 2, 0.5, 0); // along the axis there is no side
    EXPECT_EQ(up.corner[0], up.corner[1]);
}

} // namespace

// Tool 1 has a carriage that hangs lower: what tool 0 passes over it meets.
TEST(BeadGrowth, EachToolHasItsOwnHead) {
    machine::Head slim, low;
    slim.cone_height = 30;
    slim.carriage_x = slim.carriage_y = 20;
    low = slim;
    low.cone_height = 2;
    Heads heads(slim);
    heads.own.emplace(1, low);
    for (const std::uint32_t tool : {0U, 1U}) {
        MoveReader walk(Machine{heads});
        walk.add({toolpath::Role::bead, 0, 0, 0, {{0, 0, 5}, {20, 0, 5}}, {1}, {5}, {}}); // a wall 5 mm high
        walk.add({toolpath::Role::travel, 1, 0, 0, {{20, 0, 5}, {20, 8, 0.2}}, {}, {}, {}, tool});
        walk.add({toolpath::Role::bead, 1, 0, 0, {{20, 8, 0.2}, {0, 8, 0.2}}, {1}, {0.2}, {}, tool});
        const Scene scene{Tree(walk.growth.beads), Tree({}), Tree({}), Tree({})};
        const CheckResult found = check(scene, heads, walk.growth.moves, {}, 1);
        EXPECT_EQ(found.collisions.empty(), tool == 0);
        for (const Place& p : found.collisions) EXPECT_EQ(p.piece, HeadPiece::carriage);
    }
}
