// Ways through strips of triangles are as long as where the strip lies flat, and stay on it.
#include "surface/curve/strip.hpp"

#include "surface/curve/locate.hpp"

#include "../grid.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace filum::surface::curve {
namespace {

Surface sheet(const std::function<Vec3(Vec2)>& lift) {
    Notes notes;
    return surface::connect(surface::grid(20, 10, 20, 10, lift), notes);
}

// Folded along x = 10 by any angle, the way across is that on the plane.
TEST(Strip, LeadsOverSharpFolds) {
    for (const double angle : {0.0, 1.0, 2.0, 3.0}) {
        const auto fold = [&](Vec2 p) -> Vec3 {
            const double beyond = std::max(0.0, p.x - 10);
            return {std::min(p.x, 10.0) + beyond * std::cos(angle), p.y, beyond * std::sin(angle)};
        };
        const Surface s = sheet(fold);
        const Locator locator(s);
        const Place a = locator.nearest(fold({9.3, 4.2})), b = locator.nearest(fold({10.4, 4.6}));
        const Line way = through_strip(s, a, b, 5);
        ASSERT_GT(way.size(), 2U) << angle;
        EXPECT_EQ(way[0], a.point);
        EXPECT_EQ(way.places.back().point, b.point);
        EXPECT_NEAR(length(way), std::hypot(1.1, 0.4), 0.02) << angle; // by the fewest edges, not the best ones
        for (std::size_t i = 0; i + 1 < way.size(); ++i)
            for (const Vec3& p : {way[i], way[i + 1]})
                EXPECT_LT(distance(nearest_in(s, way.places[i].triangle, p), p), 1e-9);
    }
}

TEST(Strip, LeadsNowhereAcrossGaps) {
    auto mesh = surface::flat_grid(20, 10, 20, 10);
    std::erase_if(mesh.triangles, [&](const auto& t) { // a slot at x from 10 to 11, open below
        const double x = (mesh.vertices[t[0]].x + mesh.vertices[t[1]].x + mesh.vertices[t[2]].x) / 3;
        const double y = (mesh.vertices[t[0]].y + mesh.vertices[t[1]].y + mesh.vertices[t[2]].y) / 3;
        return x > 10 && x < 11 && y < 9;
    });
    Notes notes;
    const Surface s = surface::connect(mesh, notes);
    const Locator locator(s);
    const Place a = locator.nearest({9.8, 2, 0}), b = locator.nearest({11.2, 2, 0});
    EXPECT_EQ(through_strip(s, a, b, 3).size(), 0U);
    EXPECT_GT(length(through_strip(s, a, b, 30)), 14); // up to the end of the slot, and down
}

} // namespace
} // namespace filum::surface::curve
