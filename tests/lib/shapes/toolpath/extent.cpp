#include "toolpath/extent.hpp"

#include <gtest/gtest.h>

#include <cmath>

using namespace filum;
using namespace filum::toolpath;
using geom::Vec3;

namespace {

Span square(double size, double width, double height, double z) {
    const double e = (size - width) / 2;
    return {Role::bead, 0, 0, 0, {{-e, -e, z}, {e, -e, z}, {e, e, z}, {-e, e, z}, {-e, -e, z}}, {width}, {height}};
}

} // namespace

TEST(Extent, APartIsAsLargeAsItsBeads) {
    Extent e;
    EXPECT_TRUE(e.empty());
    EXPECT_EQ(e.size(), Vec3{});
    for (int layer = 1; layer <= 10; ++layer) e.add(square(10, 0.4, 0.3, 0.3 * layer));
    EXPECT_LT(distance(e.size(), {10, 10, 3}), 1e-9);
}

TEST(Extent, SupportsSkirtsConnectorsAndTravelsAreNotOfThePart) {
    Extent e;
    e.add(square(10, 0.4, 0.3, 0.3));
    for (const Feature f : {Feature::support, Feature::interface, Feature::skirt, Feature::tower}) {
        Span s = square(50, 0.4, 0.3, 5);
        s.feature = f;
        e.add(s);
    }
    for (const Role r : {Role::connector, Role::travel, Role::lift, Role::jog}) {
        Span s = square(50, 0.4, 0.3, 5);
        s.role = r;
        e.add(s);
    }
    EXPECT_LT(distance(e.size(), {10, 10, 0.3}), 1e-9);
}

// A bead on a wall: it is as wide along the wall, and as thick across it, whichever way the wall looks.
TEST(Extent, BeadsThatLean) {
    for (const double turn : {0.0, 0.7, 1.5707963267948966, 3.0}) {
        Span s{Role::bead, 0, 0, 0, {{0, -5, 0}, {0, 5, 0}}, {0.6}, {0.2}};
        s.normals.assign(2, {std::sin(turn), 0, std::cos(turn)});
        Extent e;
        e.add(s);
        const double c = std::abs(std::cos(turn)), n = std::abs(std::sin(turn));
        EXPECT_LT(distance(e.size(), {0.6 * c + 0.2 * n, 10.6, 0.6 * n + 0.2 * c}), 1e-9) << turn;
    }
}
