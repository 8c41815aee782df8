#include "route/travel.hpp"

#include "geom/angle.hpp"
#include "route/around.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace filum;
using namespace filum::route;
using collision::Options;
using collision::Room;
using collision::Scene;
using collision::Shape;
using collision::Solid;
using collision::Tree;

using geom::kDegree;

// A box without a floor.
std::vector<Solid> box(const Vec3& lo, const Vec3& hi) {
    const auto quad = [](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        return Solid{{a, b, c, d}, 0, 0};
    };
    const Vec3 a{lo.x, lo.y, lo.z}, b{hi.x, lo.y, lo.z}, c{hi.x, hi.y, lo.z}, d{lo.x, hi.y, lo.z};
    const Vec3 e{lo.x, lo.y, hi.z}, f{hi.x, lo.y, hi.z}, g{hi.x, hi.y, hi.z}, h{lo.x, hi.y, hi.z};
    return {quad(a, b, f, e), quad(b, c, g, f), quad(c, d, h, g), quad(d, a, e, h), quad(e, f, g, h)};
}

// A cone of 20 degrees, high enough for all that stands here.
machine::Head slim() {
    machine::Head head;
    head.cone_angle = 20 * kDegree;
    head.cone_height = 100;
    head.carriage_x = head.carriage_y = 0;
    return head;
}

struct World {
    Scene scene;
    Shape shape{slim()};
    Options options;
    explicit World(std::vector<Solid> part) : scene{Tree({}), Tree(std::move(part)), Tree({}), Tree({})} {}

    // The travel; each leg of it is looked at again by check(), which knows nothing of rooms.
    Travel run(const ToolFrame& from, const ToolFrame& to, const TravelOptions& o = {.lift = 1}) const {
        const Room room(scene, shape, options);
        const Travel t = travel(room, from, to, 0, o);
        std::vector<collision::Move> moves;
        double length = 0;
        for (std::size_t i = 1; i < t.stances.size(); ++i) {
            moves.push_back({t.stances[i - 1], t.stances[i]});
            length += distance(t.stances[i - 1].tip, t.stances[i].tip);
        }
        EXPECT_NEAR(t.length, length, 1e-9);
        EXPECT_EQ(t.stances.front().tip, from.tip);
        EXPECT_EQ(t.stances.back().tip, to.tip);
        EXPECT_EQ(t.free, collision::check(scene, slim(), moves, {.step = 0.05}, 1).collisions.empty());
        return t;
    }
};

double top(const Travel& t) {
    double z = t.stances.front().tip.z;
    for (const auto& s : t.stances) z = std::max(z, s.tip.z);
    return z;
}

TEST(Travel, KeepsADistanceUnderTheTip) {
    for (const double high : {0.3, 1.2, 4.0, 9.0}) {
        const World world(box({8, -3, 0}, {12, 3, high}));
        const double under = 0.5;
        const Travel t = world.run({{0, 0, 0}}, {{20, 0, 2}}, {.lift = 1, .under = under});
        EXPECT_TRUE(t.free);
        std::vector<collision::Move> lower; // without the upright legs at both ends
        for (std::size_t i = 2; i + 1 < t.stances.size(); ++i) {
            lower.push_back({t.stances[i - 1], t.stances[i]});
            lower.back().from.tip.z -= under;
            lower.back().to.tip.z -= under;
        }
        ASSERT_FALSE(lower.empty());
        EXPECT_TRUE(collision::check(world.scene, slim(), lower, {.step = 0.05}, 1).collisions.empty()) << high;
    }
}

TEST(Travel, StraightWhereNothingIsInTheWay) {
    const World world(box({8, 20, 0}, {12, 30, 40}));
    const Travel t = world.run({{0, 0, 0}}, {{20, 0, 0}});
    EXPECT_EQ(t.kind, Kind::straight);
    EXPECT_TRUE(t.free);
    EXPECT_NEAR(t.length, 22, 1e-9);
    EXPECT_EQ(t.stances.size(), 4U);
    EXPECT_EQ(world.run({{3, 3, 0}}, {{3, 3, 0}}).length, 0);
    EXPECT_EQ(world.run({{0, 0, 0}}, {{2, 0, 0}}, {.lift = 1, .min_length = 3}).length, 2);
}

// An endless low wall: over it, no higher than has to be, by the two straight lines past its edges.
TEST(Travel, OverAWallBetweenTwoPoints) {
    const World world(box({9, -500, 0}, {11, 500, 5}));
    const Travel t = world.run({{0, 0, 0}}, {{20, 0, 0}});
    EXPECT_EQ(t.kind, Kind::over);
    EXPECT_TRUE(t.free);
    // No shorter than up by 1, straight to an edge, along the wall, and the same down, except for what may be pressed
    // upon; no longer than by a corner 1 above the wall.
    EXPECT_GE(t.length, 2 * (1 + std::hypot(9, 4 - world.options.press)) + 2);
    EXPECT_LE(t.length, 2 * (1 + std::hypot(10, 5.1)));
    EXPECT_NEAR(top(t), 6, 0.1);
}

// The same wall, short and high: past its end.  The head is as wide at the wall's top as its cone.
TEST(Travel, AroundATower) {
    const World world(box({9, -3, 0}, {11, 3, 60}));
    const Travel t = world.run({{-5, 0, 0}}, {{25, 0, 0}});
    EXPECT_EQ(t.kind, Kind::around);
    EXPECT_TRUE(t.free);
    EXPECT_EQ(top(t), 1);
    // tangents to the circles about the tower's corners at which the nozzle just passes, their arcs, and the side
    const double r = 0.2 + 59 * std::tan(10 * kDegree), off = std::hypot(14, 3);
    const double arc = std::numbers::pi / 2 + std::atan2(3, 14) - std::acos(r / off);
    const double least = 2 + 2 * (std::sqrt(off * off - r * r) + r * arc) + 2;
    EXPECT_GT(t.length, least);
    EXPECT_LT(t.length, 1.05 * least); // over it 2 * 60 more
}

TEST(Travel, OverWhereAroundIsFarther) {
    const World world(box({9, -300, 0}, {11, 300, 60}));
    const Travel t = world.run({{-5, 0, 0}}, {{25, 0, 0}});
    EXPECT_EQ(t.kind, Kind::over);
    EXPECT_TRUE(t.free);
    EXPECT_LT(t.length, 2 * std::hypot(14, 59) + 2 + 2 + 4);
}

// From one side of a block to the opposite one: the tool turns by 180 degrees, and only where there is room.
TEST(Travel, FromOneSideOfABlockToTheOther) {
    const World world(box({0, 0, 0}, {20, 20, 20}));
    for (const double lift : {0.0, 1.0, 5.0}) {
        const ToolFrame from{{-0.2, 10, 10}, {-1, 0, 0}, {}}, to{{20.2, 10, 10}, {1, 0, 0}, {}};
        const Travel t = world.run(from, to, {.lift = lift});
        EXPECT_TRUE(t.free) << lift;
        EXPECT_GT(t.stances[1].tip.x, -0.2 - 60);
        for (std::size_t i = 1; i < t.stances.size(); ++i)
            EXPECT_LT(std::acos(std::min(1.0, dot(t.stances[i - 1].axis, t.stances[i].axis))), 0.1 + 1e-6);
        // leaves and comes along the axes
        EXPECT_NEAR(std::abs(t.stances[1].axis.x), 1, 1e-9);
        EXPECT_NEAR(distance(t.stances[1].tip, from.tip), -0.2 - t.stances[1].tip.x, 1e-9);
    }
    const Travel side = world.run({{-0.2, 10, 10}, {-1, 0, 0}, {}}, {{10, 10, 20.2}});
    EXPECT_TRUE(side.free);
    EXPECT_LT(side.length, 60);
}

// A stroke that ends where the head has no room: the way out is along the axis, and what follows is free.
TEST(Travel, AnEndWithoutRoomIsLeftAlongTheAxis) {
    const World world(box({1, -5, 0}, {3, 5, 20}));
    const Travel t = world.run({{0, 0, 0}}, {{-20, 0, 0}});
    EXPECT_FALSE(t.free);
    EXPECT_GT(t.stances[1].tip.z, 10);
    EXPECT_EQ(t.stances[1].tip.x, 0);
}

TEST(Around, NothingThroughAClosedRing) {
    auto solids = box({-10, -10, 0}, {10, 10, 30});
    solids.pop_back(); // no roof
    const World world(solids);
    const Room room(world.scene, world.shape, world.options);
    const Fan fan(room, {{0, 0, 0}}, {{30, 0, 0}}, 0);
    EXPECT_TRUE(around(fan, 1, 200).empty());
    EXPECT_FALSE(around(fan, 30, 200).empty());
    EXPECT_TRUE(around(fan, 1, 20).empty()); // shorter than the way
}

// The least rise is where the nozzle's side passes the edge of the wall.
TEST(Fan, TheLeastRiseBesideAWall) {
    const World world(box({1, -50, 0}, {3, 50, 20}));
    const Room room(world.scene, world.shape, world.options);
    const Fan fan(room, {{0, 0, 0}}, {{-20, 0, 0}}, 0);
    const double want = 20 - (1 - 0.2) / std::tan(10 * kDegree);
    EXPECT_GE(fan.least_rise({0, 0, 0}), want - 1e-6);
    EXPECT_LE(fan.least_rise({0, 0, 0}), want + 0.06);
    EXPECT_EQ(fan.least_rise({1, 0, 0.5}), 0.5);
}

} // namespace
