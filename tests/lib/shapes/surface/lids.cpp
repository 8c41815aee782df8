// Holes and notches that are closed, and those that must stay open.
#include "surface/lids.hpp"

#include "grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace filum::surface {
namespace {

constexpr double kTolerance = 0.05;

// A plate of 40 x 40 mm without what `out` says, in triangles of half a millimetre.
Surface plate(const std::function<bool(geom::Vec2)>& out) {
    Notes notes;
    return connect(pierced_grid(
                       40, 40, 80, 80,
                       [](geom::Vec2 p) {
                           return Vec3{p.x, p.y, 0};
                       },
                       out),
                   notes);
}

// A slot from the edge y = 0 to `deep`, `wide` about x = 20.
std::function<bool(geom::Vec2)> slot(double wide, double deep) {
    return [=](geom::Vec2 p) { return std::abs(p.x - 20) < wide / 2 && p.y < deep; };
}

TEST(Lids, ASlotIsClosedAtItsMouth) {
    const Surface s = plate(slot(3, 12));
    const SurfaceWithLids c = with_lids(s, 5, kTolerance);
    ASSERT_EQ(c.lids.size(), 1U);
    EXPECT_TRUE(c.lids[0].notch);
    EXPECT_NEAR(c.lids[0].area, 36, 1e-9);
    EXPECT_NEAR(area(c.surface), 1600, 1e-9);
    EXPECT_EQ(c.surface.rims.size(), 1U);
    EXPECT_NEAR(rim_length(c.surface, c.surface.rims[0]), 160, 1e-9);
    EXPECT_TRUE(s.on_rim(c.lids[0].vertex));
    EXPECT_NEAR(c.lids[0].middle.x, 20, 1e-9);
    EXPECT_NEAR(c.lids[0].middle.y, 6, 1e-9);
}

TEST(Lids, EverySlotOfACombIsClosed) {
    const Surface s =
        plate([](geom::Vec2 p) { return std::fmod(p.x + 2.5, 10) < 4 && p.x > 5 && p.x < 35 && p.y > 25; });
    const SurfaceWithLids c = with_lids(s, 5, kTolerance);
    EXPECT_EQ(c.lids.size(), 3U);
    EXPECT_NEAR(area(c.surface), 1600, 1e-9);
}

TEST(Lids, AHoleIsNoNotch) {
    const SurfaceWithLids c =
        with_lids(plate([](geom::Vec2 p) { return std::hypot(p.x - 20, p.y - 20) < 4; }), 5, kTolerance);
    ASSERT_EQ(c.lids.size(), 1U);
    EXPECT_FALSE(c.lids[0].notch);
}

TEST(Lids, WithRoomForAFlangeSlotsStayOpen) {
    const Surface s = plate(slot(13, 20));
    EXPECT_TRUE(with_lids(s, 3, kTolerance).lids.empty());
    EXPECT_EQ(with_lids(s, 3, kTolerance).surface.triangles.size(), s.triangles.size());
    EXPECT_EQ(with_lids(s, 4, kTolerance).lids.size(), 1U); // 13 mm are less than twice 2 x 4
}

TEST(Lids, ACornerThatGoesInIsNoNotch) {
    EXPECT_TRUE(with_lids(plate([](geom::Vec2 p) { return p.x > 15 && p.y > 15; }), 5, kTolerance).lids.empty());
}

TEST(Lids, ABayBehindANarrowMouthStaysOpen) {
    const auto out = [](geom::Vec2 p) { return slot(3, 8)(p) || (std::abs(p.x - 20) < 15 && std::abs(p.y - 22) < 14); };
    EXPECT_TRUE(with_lids(plate(out), 5, kTolerance).lids.empty());
}

TEST(Lids, ASlotRoundACornerIsClosedToo) {
    const auto out = [](geom::Vec2 p) { return slot(3, 15)(p) || (p.x > 18 && p.x < 34 && p.y > 12 && p.y < 15); };
    const SurfaceWithLids c = with_lids(plate(out), 5, kTolerance);
    ASSERT_EQ(c.lids.size(), 1U);
    EXPECT_NEAR(area(c.surface), 1600, 1e-9);
}

// A peg of the part in a wide slot, with its foot at the other side, outside of the mouth.
TEST(Lids, AnotherPartInASlotKeepsItOpen) {
    Notes notes;
    mesh::Mesh m = pierced_grid(
        40, 40, 80, 80,
        [](geom::Vec2 p) {
            return Vec3{p.x, p.y, 0};
        },
        slot(6, 12));
    const auto first = static_cast<std::uint32_t>(m.vertices.size());
    for (const Vec3& p : {Vec3{19, -5, 0}, Vec3{21, -5, 0}, Vec3{20, 8, 0}}) m.vertices.push_back(p);
    m.triangles.push_back({first, first + 1, first + 2});
    EXPECT_TRUE(with_lids(connect(std::move(m), notes), 5, kTolerance).lids.empty());
}

} // namespace
} // namespace filum::surface
