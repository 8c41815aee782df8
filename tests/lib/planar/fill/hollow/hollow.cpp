#include "fill/hollow/hollow.hpp"

#include "cases.hpp"
#include "fill/spiral.hpp"

#include <numbers>

namespace filum::fill::hollow {
namespace {

using polygon::AreaKind;
using polygon::InfillPattern;
using polygon::Loops;
using toolpath::Feature;

// Regions with sparse parts: all inside, or what a random blob covers, with one spacing or two.
std::vector<Case> sparse_cases(unsigned seeds) {
    auto out = random_cases(seeds);
    for (auto& [r, seed] : out) {
        r.walls = 1 + seed % 3;
        const Loops inside = polygon::offset(r.loops, -kBead * r.walls);
        Loops sparse = inside;
        if (seed % 2 == 0) sparse = polygon::intersect(sparse, test::disc({3, 2}, 9));
        if (seed % 5 == 0) sparse = polygon::subtract(sparse, test::disc({-2, 1}, 2));
        const auto pattern = seed % 4 == 1   ? InfillPattern::wave
                             : seed % 4 == 2 ? InfillPattern::concentric
                                             : InfillPattern::rows;
        const double spacing = 1.5 + 0.2 * (seed % 10);
        if (seed % 3 == 0) {
            const Loops dense = polygon::intersect(sparse, test::disc({4, 0}, 6));
            sparse = polygon::subtract(sparse, dense);
            r.areas.push_back({AreaKind::sparse, dense, 0.3 * seed, spacing / 2, pattern});
        }
        r.areas.push_back({AreaKind::sparse, sparse, 0.3 * seed, spacing, pattern});
        if (seed % 2 == 0) { // not all of it is left where it is solid
            const Loops air = polygon::intersect(inside, test::disc({-1, -2}, 4));
            if (!air.empty()) r.areas.push_back({AreaKind::bridge, air, 0.2 * seed, 0, {}});
        }
    }
    return out;
}

TEST(Hollow, OneClosedCurveThatDoesNotCrossItself) {
    for (const Case& c : sparse_cases(60)) EXPECT_EQ(sound_curves(c), 1U) << c.seed;
}

TEST(Hollow, ConcentricLinesAreOneCurveWithWallsAndSkins) {
    std::size_t more = 0, all = 0;
    for (Case& c : sparse_cases(40)) {
        for (auto& a : c.region.areas)
            if (a.kind == AreaKind::sparse)
                a = {a.kind, a.loops, 0, 1.5 + 0.2 * (c.seed % 10), InfillPattern::concentric};
        Notes notes;
        const auto paths = fill(c.region, {.bead_width = kBead}, notes);
        EXPECT_EQ(fill::join::crossing_pairs(paths.curves, kBead).size(), 0U) << c.seed;
        EXPECT_EQ(paths.curves.size() > 1, !notes.empty() && notes.back().code == NoteCode::ring_unjoined) << c.seed;
        more += paths.curves.size() > 1 ? 1 : 0;
        ++all;
    }
    EXPECT_LE(more, all / 40); // where no window is free for an exchange at a link's end: told
}

// Walls and skins are solid: beads cover what is not sparse.
TEST(Hollow, WallsAndSkinsAreCovered) {
    double uncovered = 0, all = 0;
    for (const Case& c : sparse_cases(30)) {
        Notes notes;
        const auto paths = fill(c.region, {.bead_width = kBead}, notes);
        const Loops solid = solid_part(c.region);
        const double area = polygon::signed_area(solid);
        uncovered += area * (1 - test::coverage(solid, paths.curves));
        all += area;
    }
    EXPECT_LT(uncovered, 0.02 * all);
}

TEST(Hollow, FeaturesTellWhereABeadLies) {
    polygon::Region r;
    r.z = 1;
    r.height = 0.2;
    r.walls = 2;
    r.loops = test::loop({{0, 0}, {40, 0}, {40, 20}, {0, 20}});
    r.area = 800;
    r.areas.push_back({AreaKind::sparse, test::loop({{0.8, 0.8}, {20, 0.8}, {20, 19.2}, {0.8, 19.2}}), 0.7, 3, {}});
    Notes notes;
    const auto paths = fill(r, {.bead_width = kBead}, notes);
    ASSERT_EQ(paths.curves.size(), 1U);
    const auto& c = paths.curves[0];
    ASSERT_EQ(c.feature.size(), c.points.size());
    double laid[toolpath::kFeatures] = {};
    for (std::size_t i = 0; i < c.points.size(); ++i)
        laid[static_cast<std::size_t>(c.feature[i])] +=
            geom::distance(c.points[i], c.points[(i + 1) % c.points.size()]);
    const auto of = [&](Feature f) { return laid[static_cast<std::size_t>(f)]; };
    EXPECT_NEAR(of(Feature::outer_wall), 118.4, 3);
    EXPECT_NEAR(of(Feature::wall), 115.2, 3);
    EXPECT_NEAR(of(Feature::solid) * kBead, 19.2 * 18.4, 8);
    EXPECT_NEAR(of(Feature::infill) * kBead, 19.2 * 18.4 * 0.4 / 3 + 0.4 * 37, 15);
}

// The number of points depends on the ends of rows, four or five at each, for any direction: joins to the wall
// take two, turns along the wall two or three.
TEST(Hollow, LongRowsTakeFewPoints) {
    for (const double direction : {0.0, 0.3, std::numbers::pi / 4, 1.2, std::numbers::pi / 2}) {
        polygon::Region r;
        r.z = 1;
        r.height = 0.2;
        r.walls = 2;
        r.loops = test::loop({{0, 0}, {300, 0}, {300, 300}, {0, 300}});
        r.area = 300 * 300;
        r.areas.push_back({AreaKind::sparse, polygon::offset(r.loops, -2 * kBead), direction, 2.67, {}});
        EXPECT_EQ(sound_curves({r, 0}), 1U);
        Notes notes;
        const auto curve = fill(r, {.bead_width = kBead}, notes).curves[0];
        std::size_t rows = 0, changes = 0;
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const std::size_t j = (i + 1) % curve.points.size();
            rows += geom::distance(curve.points[i], curve.points[j]) > 5 ? 1 : 0;
            changes += curve.feature[i] != curve.feature[j] ? 1 : 0;
        }
        EXPECT_GT(rows, 100U);
        EXPECT_LT(curve.points.size(), 8 * rows + 40) << direction;
        EXPECT_LT(changes, rows + 40) << direction;
    }
}

TEST(Hollow, RowsOfABridgeRunAlongItAndTurnWhereItIsCarried) {
    const Loops plate = test::loop({{0, 0}, {30, 0}, {30, 20}, {0, 20}});
    // in the middle of it; and all of it but its walls, so that rows end at these
    for (const auto& [air, direction] : {std::pair{test::disc({15, 10}, 6), 0.0},
                                         {test::disc({15, 10}, 6), 0.5},
                                         {test::disc({15, 10}, 6), std::numbers::pi / 2},
                                         {test::disc({15, 10}, 6), 2.4},
                                         {polygon::offset(plate, -2 * kBead), std::numbers::pi / 2},
                                         {polygon::offset(plate, -2 * kBead), 0.0}}) {
        polygon::Region r;
        r.walls = 2;
        r.loops = plate;
        r.area = 600;
        const Loops inside = polygon::offset(air, -3 * kBead); // turns are two beads deep, and are rounded
        r.areas.push_back({AreaKind::bridge, air, direction, 0, {}});
        Notes notes;
        const auto paths = fill(r, {.bead_width = kBead}, notes);
        ASSERT_EQ(paths.curves.size(), 1U);
        EXPECT_EQ(fill::join::crossing_pairs(paths.curves, kBead).size(), 0U);
        const auto& c = paths.curves[0];
        const geom::Vec2 along{std::cos(direction), std::sin(direction)};
        double all = 0, askew = 0, other = 0;
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const geom::Vec2 a = c.points[i], d = c.points[(i + 1) % c.points.size()] - a;
            const int parts = 1 + static_cast<int>(geom::norm(d) / 0.05);
            const double length = geom::norm(d) / parts;
            for (int k = 0; k < parts; ++k) {
                if (!polygon::contains(inside, a + ((k + 0.5) / parts) * d)) continue;
                all += length;
                askew += std::abs(cross(along, d)) > 0.1 * geom::norm(d) ? length : 0;
                other += c.feature[i] != Feature::bridge ? length : 0;
            }
        }
        EXPECT_NEAR(all * kBead, polygon::signed_area(inside), 0.02 * polygon::signed_area(inside)) << direction;
        EXPECT_LT(askew, 0.01 * all) << direction;
        EXPECT_EQ(other, 0) << direction;
    }
}

} // namespace
} // namespace filum::fill::hollow
