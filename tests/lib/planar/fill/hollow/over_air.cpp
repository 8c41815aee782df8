// Walls over air count as bridges.
#include "cases.hpp"

namespace filum::fill::hollow {
namespace {

using polygon::AreaKind;
using polygon::Loops;
using toolpath::Feature;

// A plate of 40 x 20 mm with two walls; its bottom is seen in `bottom`.
polygon::Region plate_over(const Loops& bottom) {
    polygon::Region r;
    r.z = r.height = 0.2;
    r.loops = test::rectangle(0, 0, 40, 20);
    r.area = 800;
    r.walls = 2;
    if (!bottom.empty()) r.areas.push_back({AreaKind::skin_bottom, bottom, 0, 0, {}});
    r.areas.push_back({AreaKind::sparse, test::rectangle(2, 2, 38, 18), 0.7, 3, polygon::InfillPattern::rows});
    return r;
}

struct WallLengths {
    double air = 0, carried = 0; // mm of walls with the feature bridge, and of other walls
    double wrong = 0;            // mm of them on the wrong side of x
};

// Walls of a fill, where the plate is carried up to `x`; a stretch of a bead on either side may be either.
WallLengths walls_of(const polygon::Region& r, double x) {
    Notes notes;
    const auto paths = fill(r, {.bead_width = kBead}, notes);
    WallLengths out;
    for (const auto& c : paths.curves) {
        EXPECT_EQ(c.feature.size(), c.points.size());
        EXPECT_TRUE(c.width.size() == 1 || c.width.size() == c.points.size());
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const geom::Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
            const bool over_air = c.feature[i] == Feature::bridge;
            if (!over_air && c.feature[i] != Feature::wall && c.feature[i] != Feature::outer_wall) continue;
            const double length = geom::distance(a, b), middle = (a.x + b.x) / 2;
            (over_air ? out.air : out.carried) += length;
            if (over_air != (middle > x) && std::abs(middle - x) > 2 * kBead) out.wrong += length;
        }
    }
    EXPECT_EQ(fill::join::crossing_pairs(paths.curves, kBead).size(), 0U);
    return out;
}

TEST(HollowOverAir, WallsBeginToBeBridgesWhereNothingCarriesThem) {
    for (const double x : {5.0, 13.7, 21.3, 33.0}) {
        const WallLengths w = walls_of(plate_over(test::rectangle(x, 0, 40, 20)), x);
        const double one_side = 2 * (40 - x) + 20; // of the outline, right of x
        EXPECT_NEAR(w.air, 2 * one_side, 0.06 * 2 * one_side) << x;
        EXPECT_LT(w.wrong, 0.02 * w.air) << x;
        EXPECT_GT(w.carried, 2 * (2 * x + 20) * 0.9) << x;
    }
}

TEST(HollowOverAir, SmallOverhangsAndWholeBottomsStayWalls) {
    EXPECT_EQ(walls_of(plate_over(test::rectangle(39.7, 0, 40, 20)), 0).air, 0); // less than a bead
    EXPECT_EQ(walls_of(plate_over(test::rectangle(0, 0, 40, 20)), 0).air, 0);    // on the bed
    EXPECT_EQ(walls_of(plate_over({}), 0).air, 0);
    EXPECT_EQ(walls_of(plate_over(test::rectangle(15, 6, 25, 14)), 0).air, 0); // under the infill alone
}

} // namespace
} // namespace filum::fill::hollow
