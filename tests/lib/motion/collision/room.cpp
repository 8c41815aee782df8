#include "collision/room.hpp"

#include "geom/angle.hpp"
#include "walls.hpp"

#include <gtest/gtest.h>

#include <random>

namespace {

using namespace filum;
using namespace filum::collision;

using geom::kDegree;
using walls::triangle;
using walls::wall;

TEST(Room, ToAWallAsFarAsTheHeadIsWide) {
    const Scene scene{Tree({}), Tree(wall(30, 5)), Tree({}), Tree({})};
    const machine::Head head;
    const Shape shape(head);
    const Options options, far{.margin = 1};
    const double reach = 0.2 + 5 * std::tan(30 * kDegree); // of the cone, as high as the wall
    const Room room(scene, shape, options), wider(scene, shape, far);
    EXPECT_TRUE(room.at({{30 - reach - 0.001, 0, 0}}, 0));
    EXPECT_FALSE(room.at({{30 - reach + 0.001, 0, 0}}, 0));
    EXPECT_TRUE(wider.at({{30 - reach - 1 / std::cos(30 * kDegree) - 0.001, 0, 0}}, 0));
    EXPECT_FALSE(wider.at({{30 - reach - 1 / std::cos(30 * kDegree) + 0.001, 0, 0}}, 0));
    EXPECT_TRUE(room.at({{30, 0, 5}}, 0)); // above it

    const auto share = room.blocked({{{0, 0, 0}}, {{60, 0, 0}}});
    ASSERT_TRUE(share);
    EXPECT_NEAR(*share * 60, 30 - reach, 0.03);
    EXPECT_FALSE(room.blocked({{{0, 0, 0}}, {{30 - reach - 0.02, 0, 0}}}));
    EXPECT_FALSE(room.blocked({{{0, 0, 5}}, {{60, 0, 5}}}));
    // down from there meets the wall when it is as low as the cone is wide
    const auto down = room.blocked({{{29, 0, 10}}, {{29, 0, 0}}});
    ASSERT_TRUE(down);
    EXPECT_NEAR(10 - *down * 10, 5 - 0.8 / std::tan(30 * kDegree), 0.03);
}

TEST(Room, BeadsCountSinceTheyAreThere) {
    const Solid tall{{Vec3{0, -5, 3}, {0, -5, 3}, {0, 5, 3}, {0, 5, 3}}, 0.1, 7};
    const Scene scene{Tree({tall}), Tree({}), Tree({}), Tree({})};
    const machine::Head head;
    const Shape shape(head);
    const Options options;
    const Room room(scene, shape, options);
    Move move{{{-9, 0, 0}}, {{9, 0, 0}}};
    move.before = 7;
    EXPECT_FALSE(room.blocked(move));
    EXPECT_TRUE(room.at({{0, 0, 0}}, 7));
    move.before = 8;
    EXPECT_TRUE(room.blocked(move));
    EXPECT_FALSE(room.at({{0, 0, 0}}, 8));
}

// Where there is room all along, check() finds nothing, for any step; where check() finds something, there is
// none.
TEST(Room, AgreesWithTheCheck) {
    std::mt19937 engine{5};
    const auto random = [&](double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine); };
    const auto place = [&](double size) { return Vec3{random(-size, size), random(-size, size), random(-size, size)}; };
    std::vector<Solid> solids;
    for (int i = 0; i < 20; ++i) {
        const Vec3 p = place(40);
        solids.push_back(triangle(p, p + place(5), p + place(5)));
    }
    const Scene scene{Tree({}), Tree(solids), Tree({}), Tree({})};
    machine::Head head;
    head.cone_angle = 20 * kDegree;
    head.cone_height = 30;
    head.carriage_x = head.carriage_y = 4;
    const Shape shape(head);
    const Options options;
    const Room room(scene, shape, options);
    int free = 0, met = 0;
    for (int i = 0; i < 200; ++i) {
        const auto stance = [&] {
            const Vec3 v{random(-1, 1), random(-1, 1), random(0.1, 1)};
            return ToolFrame{place(50), (1 / norm(v)) * v, {}};
        };
        Move move{stance(), stance()};
        move.to.tip = move.from.tip + place(6);
        const bool blocked = room.blocked(move).has_value();
        for (const double step : {3.0, 0.5, 0.1})
            if (!check(scene, head, {move}, {.step = step}, 1).collisions.empty()) {
                EXPECT_TRUE(blocked) << i << " step " << step;
                ++met;
            }
        free += blocked ? 0 : 1;
    }
    EXPECT_GT(free, 30);
    EXPECT_GT(met, 150);
}

} // namespace
