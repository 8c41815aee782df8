#include "surface/facing.hpp"

#include "grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace filum;

namespace facing {

surface::Surface dome(double high) { // 20 x 20 mm
    Notes notes;
    const auto lift = [&](geom::Vec2 p) {
        return geom::Vec3{p.x, p.y, high * p.x * (20 - p.x) * p.y * (20 - p.y) / 1e4};
    };
    return surface::connect(surface::grid(20, 20, 10, 10, lift), notes);
}

// An upright cylinder of 10 mm radius, 20 mm high, that turns by `degrees` about z and faces its axis.
surface::Surface inside_of_arc(double degrees) {
    Notes notes;
    const double turn = degrees * std::numbers::pi / 180;
    const auto bend = [&](geom::Vec2 p) {
        const double angle = p.x / 20 * turn;
        return geom::Vec3{10 * std::cos(angle), 10 * std::sin(angle), 20 - p.y};
    };
    return surface::connect(surface::grid(20, 20, 40, 10, bend), notes);
}

} // namespace facing

TEST(Facing, DomesAndSheetsThatFaceDownAreFound) {
    for (const double high : {0.0, 0.5, 5.0}) {
        const surface::Surface s = facing::dome(high);
        EXPECT_EQ(surface::inward(s).components, 0U) << high;
        EXPECT_EQ(surface::inward(surface::flipped(s)).components, 1U) << high;
        EXPECT_NEAR(surface::inward(surface::flipped(s)).area, surface::area(s), 1e-9);
    }
    EXPECT_EQ(surface::inward(facing::dome(-5)).components, 0U) << "a bowl that is filled from above";
}

// From the shape alone, the inside of a fillet looks like the outside of a ridge.
TEST(Facing, AConcavePartFacesInwardsFromHalfATurnOn) {
    for (const double degrees : {30, 60, 90, 120, 150}) {
        const surface::Surface s = facing::inside_of_arc(degrees);
        EXPECT_EQ(surface::inward(s).components, 0U) << degrees;
        EXPECT_EQ(surface::inward(surface::flipped(s)).components, 0U) << degrees;
    }
    for (const double degrees : {180, 210, 270, 330}) {
        const surface::Surface s = facing::inside_of_arc(degrees);
        EXPECT_EQ(surface::inward(s).components, 1U) << degrees;
        EXPECT_EQ(surface::inward(surface::flipped(s)).components, 0U) << degrees;
    }
}

// Two boxes, each facing outwards or inwards, the whole turned round: only bodies that faced inwards are turned.
TEST(Facing, OfTwoBodiesTheOneThatFacesInwardsIsTurned) {
    for (const unsigned inwards : {0U, 1U, 2U, 3U}) {
        mesh::Mesh m;
        for (std::uint32_t body = 0; body < 2; ++body) {
            const std::uint32_t o = 4 * body;
            for (const geom::Vec3& v : {geom::Vec3{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}})
                m.vertices.push_back(geom::Vec3(v) + geom::Vec3{20.0 * body, 0, 0});
            for (mesh::Triangle t : {mesh::Triangle{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
                if ((inwards >> body & 1U) != 0) std::swap(t[1], t[2]);
                m.triangles.push_back({t[0] + o, t[1] + o, t[2] + o});
            }
        }
        Notes notes;
        const surface::Surface s = surface::connect(m, notes), t = surface::flipped(s);
        EXPECT_EQ(surface::inward(t).components, inwards == 0 ? 2U : 0U) << inwards;
        EXPECT_EQ(t.triangles.size(), 8U);
        EXPECT_EQ(t.components, 2U);
    }
}

TEST(Facing, TurnedRoundTwiceItIsTheSame) {
    const surface::Surface s = facing::dome(3), t = surface::flipped(surface::flipped(s));
    EXPECT_EQ(s.triangles, t.triangles);
    EXPECT_EQ(s.twin, t.twin);
    EXPECT_EQ(s.rims.size(), t.rims.size());
}
