#include "render/tubes.hpp"

#include <gtest/gtest.h>

namespace filum::render {

namespace {

using geom::Vec3;

// Where a ray along -y at the height `z` first hits, y of the part; nothing: -1.
double seen(const Tubes& tubes, double z) {
    const Vec3 from{0, 50 - tubes.centre().y, z - tubes.centre().z};
    const auto hit = tubes.shoot(from, {Vec3{0, -1, 0}, {0, -1, 0}, {0, -1, 0}, {0, -1, 0}})[0];
    return hit.any ? 50 - static_cast<double>(hit.distance) : -1;
}

// A bead of 1 x 0.2 mm on a wall at y = 6, led with its tool level.
TEST(Tubes, ABeadOnAWallIsAsWideAndHighAsItIs) {
    Scene s;
    s.spans.push_back({toolpath::Role::bead, 0, 0, 0, {{-5, 6.2, 1}, {5, 6.2, 1}}, {1}, {0.2}, {{0, 1, 0}, {0, 1, 0}}});
    const Tubes tubes(s, tint(s, ColourBy::stroke, nullptr), false, 1);
    EXPECT_NEAR(seen(tubes, 1), 6.2, 0.03);
    EXPECT_NEAR(seen(tubes, 1.5), 6, 0.05);
    EXPECT_NEAR(seen(tubes, 0.5), 6, 0.05);
    EXPECT_EQ(seen(tubes, 1.8), -1);
}

// What is printed upright in the same scene has its top where the nozzle was.
TEST(Tubes, BeadsOfACoreBelowAPatchKeepTheirTops) {
    Scene s;
    s.spans.push_back({toolpath::Role::bead, 0, 0, 0, {{-5, 0, 1}, {5, 0, 1}}, {0.8}, {0.4}});
    s.spans.push_back({toolpath::Role::bead, 1, 0, 0, {{-5, 9, 1}, {5, 9, 1}}, {1}, {0.2}, {{0, 1, 0}, {0, 1, 0}}});
    const Tubes tubes(s, tint(s, ColourBy::stroke, nullptr), false, 1);
    const Vec3 above{0, 0 - tubes.centre().y, 50 - tubes.centre().z}, down{0, 0, -1};
    const auto hit = tubes.shoot(above, {down, down, down, down})[0];
    ASSERT_TRUE(hit.any);
    EXPECT_NEAR(50 - static_cast<double>(hit.distance), 1, 0.02);
}

} // namespace

} // namespace filum::render
