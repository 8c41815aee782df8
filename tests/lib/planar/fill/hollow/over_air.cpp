// Walls over air count as bridges.
#include "cases.hpp"
#include "polygon/clip.hpp"
#include "polygon/inside_test.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

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

// The lengths of walls of a fill near the line x = `at`, by their share over air in percent.
std::map<int, double> shares_near(const toolpath::RegionPaths& paths, double at) {
    std::map<int, double> out;
    for (const auto& c : paths.curves)
        for (std::size_t i = 0; i < c.feature.size(); ++i) {
            const geom::Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
            if (std::abs(a.x - at) < 0.05 && std::abs(b.x - at) < 0.05) out[c.over_air_at(i)] += geom::distance(a, b);
        }
    return out;
}

TEST(HollowOverAir, TheShareOfALeaningWallOverAirIsThatOfItsLean) {
    for (int degrees = 15; degrees <= 75; degrees += 5) {
        const double out = 0.2 * std::tan(degrees * std::numbers::pi / 180); // mm beyond the layer below
        const polygon::Region r = plate_over(test::rectangle(40 - out, 0, 40, 20));
        Notes notes;
        const auto paths = fill(r, {.bead_width = kBead, .overhang_shares = true}, notes);
        for (const int wall : {0, 1}) {
            const double expected = 100 * std::clamp(out / kBead - wall, 0.0, 1.0);
            double length = 0, off = 0;
            for (const auto& [percent, mm] : shares_near(paths, 40 - (wall + 0.5) * kBead)) {
                length += mm;
                off += std::abs(percent - expected) > 5.01 ? mm : 0;
            }
            EXPECT_GT(length, 15) << degrees;
            EXPECT_LT(off, 0.1 * length) << degrees << " degrees, wall " << wall << ", " << expected << " %";
        }
        for (const auto& [percent, mm] : shares_near(paths, kBead / 2)) EXPECT_EQ(percent, 0) << mm; // carried
    }
}

TEST(HollowOverAir, SharesAreMeasuredOnlyWhereTheyAreWantedAndWallsStandOut) {
    Notes notes;
    const auto any = [](const toolpath::RegionPaths& paths) {
        return std::ranges::any_of(paths.curves, [](const auto& c) {
            return std::ranges::any_of(c.over_air, [](int percent) { return percent > 0; });
        });
    };
    const polygon::Region leaning = plate_over(test::rectangle(39.8, 0, 40, 20));
    EXPECT_TRUE(any(fill(leaning, {.bead_width = kBead, .overhang_shares = true}, notes)));
    EXPECT_FALSE(any(fill(leaning, {.bead_width = kBead}, notes)));
    for (const auto& none : {Loops{}, test::rectangle(0, 0, 40, 20), test::rectangle(15, 6, 25, 14)})
        EXPECT_FALSE(any(fill(plate_over(none), {.bead_width = kBead, .overhang_shares = true}, notes)));
}

// The share of a bead over air, counted on points across the bead: is it right on outlines that no rule suits?
TEST(HollowOverAir, SharesOfRandomRegionsAreThoseOfPointsAcrossTheBead) {
    std::size_t compared = 0, off = 0;
    for (const Case& each : random_cases(12)) {
        polygon::Region r = each.region;
        const Loops below = polygon::offset(r.loops, -0.25 * kBead * (1 + r.layer % 6), polygon::kBeadArc);
        const Loops air = polygon::opened(polygon::subtract(r.loops, below), 0.02, polygon::kBeadArc);
        if (below.empty() || air.empty()) continue;
        r.areas = {{AreaKind::skin_bottom, air, 0, 0, {}}};
        r.areas.push_back({AreaKind::sparse, r.loops, 0.7, 3, polygon::InfillPattern::rows});
        Notes notes;
        const polygon::InsideTest over(air);
        for (const auto& c : fill(r, {.bead_width = kBead, .overhang_shares = true}, notes).curves)
            for (std::size_t i = 0; i < c.feature.size(); ++i) {
                const geom::Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
                if (c.feature[i] != Feature::outer_wall || geom::distance(a, b) < kBead) continue;
                const geom::Vec2 across = geom::left_of((1 / geom::distance(a, b)) * (b - a));
                constexpr int kPoints = 40;
                int count = 0;
                for (int k = 0; k < kPoints; ++k)
                    count += over(geom::lerp(a, b, 0.5) + ((k + 0.5) / kPoints - 0.5) * c.width_at(i) * across) ? 1 : 0;
                ++compared;
                off += std::abs(100.0 * count / kPoints - c.over_air_at(i)) > 12 ? 1 : 0;
            }
    }
    EXPECT_GT(compared, kSanitized ? 40U : 200U); // fewer cases then
    EXPECT_LT(static_cast<double>(off), 0.05 * static_cast<double>(compared));
}

} // namespace
} // namespace filum::fill::hollow
