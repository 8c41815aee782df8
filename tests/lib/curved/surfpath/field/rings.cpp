// Whole rings lie a spacing apart, half a spacing from the rim.
#include "surfpath/field/rings.hpp"

#include "../../../shapes/surface/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace filum::surfpath::field {
namespace {

TEST(WholeRings, OfARectangleAreRectangles) {
    Notes notes;
    const surface::Sheet sheet{surface::connect(surface::flat_grid(20, 14, 27, 19), notes), {}, {}};
    const auto rings = whole_rings(sheet, 1);
    ASSERT_EQ(rings.size(), 7U);
    for (std::size_t i = 0; i < rings.size(); ++i) {
        SCOPED_TRACE(i);
        const double level = 0.5 + static_cast<double>(i);
        EXPECT_TRUE(rings[i].closed);
        // corners are cut by less than a triangle's side
        EXPECT_NEAR(surface::curve::length(rings[i]), 2 * (20 + 14) - 8 * level, 2);
        for (const auto& p : rings[i].places) {
            const double off = std::min({p.point.x, 20 - p.point.x, p.point.y, 14 - p.point.y});
            EXPECT_NEAR(off, level, 1e-3);
        }
    }
}

TEST(WholeRings, AClosedSurfaceWithoutSourcesHasNone) {
    mesh::Mesh ball; // an octahedron
    ball.vertices = {{9, 0, 0}, {-9, 0, 0}, {0, 9, 0}, {0, -9, 0}, {0, 0, 9}, {0, 0, -9}};
    ball.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    Notes notes;
    EXPECT_TRUE(whole_rings({surface::connect(ball, notes), {}, {}}, 1).empty());
}

} // namespace
} // namespace filum::surfpath::field
