#include "surface/facing.hpp"

#include "grid.hpp"

#include <gtest/gtest.h>

using namespace filum;

namespace facing {

surface::Surface dome(double high) { // 20 x 20 mm
    Notes notes;
    const auto lift = [&](geom::Vec2 p) {
        return geom::Vec3{p.x, p.y, high * p.x * (20 - p.x) * p.y * (20 - p.y) / 1e4};
    };
    return surface::connect(surface::grid(20, 20, 10, 10, lift), notes);
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

TEST(Facing, TurnedRoundTwiceItIsTheSame) {
    const surface::Surface s = facing::dome(3), t = surface::flipped(surface::flipped(s));
    EXPECT_EQ(s.triangles, t.triangles);
    EXPECT_EQ(s.twin, t.twin);
    EXPECT_EQ(s.rims.size(), t.rims.size());
}
