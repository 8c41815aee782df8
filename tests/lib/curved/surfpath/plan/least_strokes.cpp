// Bounds on strokes, where it is plain how few there can be.
#include "surfpath/plan/least_strokes.hpp"

#include "../../../shapes/surface/grid.hpp"
#include "surfpath/surfpath.hpp"

#include "../plans.hpp"

#include <gtest/gtest.h>

namespace filum::surfpath {
namespace {

Surface of(const mesh::Mesh& mesh) {
    Notes notes;
    return surface::connect(mesh, notes);
}

// A bar of 81 x `wide` mm with five teeth, each `wide` mm wide and `tooth` mm long.
mesh::Mesh comb(double tooth, double wide) {
    const double high = tooth + wide;
    return surface::pierced_grid(
        81, high, 162, static_cast<int>(2 * high),
        [](geom::Vec2 p) {
            return Vec3{p.x - 40, p.y - 40, 0};
        },
        [=](geom::Vec2 p) { return p.y > wide && std::fmod(p.x, 20) > wide; });
}

std::size_t least(const mesh::Mesh& mesh, double cut_length = 50) {
    const Surface s = of(mesh);
    return least_strokes(s, std::vector<char>(s.components, 1), {1, cut_length});
}

TEST(LeastStrokes, OfWhatLeavesRoomToComeBackIsOne) {
    EXPECT_EQ(least(surface::flat_grid(60, 40, 60, 40)), 1U);
    EXPECT_EQ(least(surface::flat_grid(200, 1.5, 200, 2)), 1U);
    EXPECT_EQ(least(comb(70, 2)), 1U); // in and out beside each other
}

TEST(LeastStrokes, TwoForFourNarrowTeethThreeForFiveAndOneWhereTheWayBackIsCheap) {
    EXPECT_EQ(least(comb(70, 1)), 3U);
    EXPECT_EQ(least(comb(40, 1)), 1U); // twice 40 mm is less than what a tooth holds, and 50
    EXPECT_EQ(least(comb(40, 1), 20), 3U);
    EXPECT_EQ(least(comb(70, 1), 100), 1U);
}

TEST(LeastStrokes, EachComponentTakesOneIfAnythingIsLaidThere) {
    auto mesh = surface::flat_grid(10, 10, 10, 10);
    const auto other = surface::grid(10, 10, 10, 10, [](geom::Vec2 p) { return Vec3{p.x + 20, p.y, 0}; });
    const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (auto t : other.triangles) mesh.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    const Surface s = of(mesh);
    ASSERT_EQ(s.components, 2U);
    EXPECT_EQ(least_strokes(s, std::vector<char>{1, 1}, {}), 2U);
    EXPECT_EQ(least_strokes(s, std::vector<char>{0, 1}, {}), 1U);
}

// What is laid keeps to it, and takes one more at most: teeth as wide as a line have one in their middle.
TEST(LeastStrokes, AreNoMoreThanHybridTakesAndOneLessAtLeast) {
    for (const double tooth : {20.0, 70.0})
        for (const double radius : {0.5, 2.4}) {
            const surface::Sheet sheet{of(comb(tooth, 1)), {}, {}};
            const Options o{.algorithm = Algorithm::hybrid, .least_radius = radius};
            Plan p = plan_paths(sheet, o);
            report_cuts_bound(sheet.surface, {o.spacing, o.cut_length}, p);
            EXPECT_EQ(fact(p, "cuts-bound"), tooth > 50 ? 2 : 0);
            const auto cuts = static_cast<double>(p.strokes.size()) - 1;
            EXPECT_GE(cuts, fact(p, "cuts-bound")) << tooth;
            // Two passes along teeth of 20 mm would cost less than a cut, but in 1 mm no turn of 2.4 mm leads back.
            EXPECT_LE(cuts, tooth < 50 && radius > 1 ? 3 : fact(p, "cuts-bound") + 1) << tooth;
            EXPECT_GT(covered(sheet.surface, p), 0.97) << tooth;
        }
}

} // namespace
} // namespace filum::surfpath
