#include "hollow/hollow.hpp"

#include "../fill/pattern_check.hpp"
#include "fill/spiral.hpp"

namespace filum::hollow {
namespace {

using polygon::AreaKind;
using polygon::Loops;
using polygon::Pattern;
using toolpath::Feature;

constexpr double kWidth = 0.4;

struct Case {
    polygon::Region region;
    unsigned seed;
};

// Regions of many shapes, parts of which are sparse: all inside, or what a random blob covers, with one spacing or two.
std::vector<Case> random_cases(unsigned seeds) {
    std::vector<Case> out;
    for (unsigned seed = 0; seed < seeds; ++seed)
        for (Loops loops : test::random_regions(seed)) {
            for (auto& p : loops.points) p = 2.0 * p;
            polygon::Region r;
            r.layer = seed, r.z = 0.2 * seed + 0.2, r.height = 0.2, r.walls = 1 + seed % 3;
            r.area = polygon::signed_area(loops);
            Loops sparse = polygon::offset(loops, -kWidth * r.walls);
            if (seed % 2 == 0) sparse = polygon::intersect(sparse, test::disc({3, 2}, 9));
            if (seed % 5 == 0) sparse = polygon::subtract(sparse, test::disc({-2, 1}, 2));
            const auto pattern = seed % 4 == 1 ? Pattern::wave : Pattern::rows;
            const double spacing = 1.5 + 0.2 * (seed % 10);
            if (seed % 3 == 0) {
                const Loops dense = polygon::intersect(sparse, test::disc({4, 0}, 6));
                sparse = polygon::subtract(sparse, dense);
                r.areas.push_back({AreaKind::sparse, dense, 0.3 * seed, spacing / 2, pattern});
            }
            r.areas.push_back({AreaKind::sparse, sparse, 0.3 * seed, spacing, pattern});
            r.loops = std::move(loops);
            out.push_back({std::move(r), seed});
        }
    return out;
}

TEST(Hollow, OneClosedCurveThatDoesNotCrossItself) {
    std::size_t more = 0, all = 0;
    for (const Case& c : random_cases(60)) {
        Notes notes;
        const auto paths = fill(c.region, {.bead_width = kWidth}, notes);
        ++all;
        ASSERT_FALSE(paths.curves.empty()) << c.seed;
        for (const auto& curve : paths.curves) EXPECT_TRUE(curve.closed);
        EXPECT_EQ(fill::count_crossings(paths.curves, kWidth), 0U) << c.seed;
        if (paths.curves.size() > 1) ++more;
        EXPECT_EQ(paths.curves.size() > 1, !notes.empty() && notes.back().what == "ring not joined") << c.seed;
        EXPECT_LT(test::farthest_outside(c.region.loops, paths.curves), 0.12)
            << c.seed; // acute tips may be moved a little
    }
    EXPECT_EQ(more, 0U) << "of " << all;
}

// Walls and skins are solid: beads cover what is not sparse.
TEST(Hollow, WallsAndSkinsAreCovered) {
    double uncovered = 0, all = 0;
    for (const Case& c : random_cases(30)) {
        Notes notes;
        const auto paths = fill(c.region, {.bead_width = kWidth}, notes);
        Loops solid = c.region.loops;
        for (const auto& a : c.region.areas) solid = polygon::subtract(solid, a.loops);
        const double area = polygon::signed_area(solid);
        uncovered += area * (1 - test::coverage(solid, paths.curves)), all += area;
    }
    EXPECT_LT(uncovered, 0.02 * all);
}

TEST(Hollow, FeaturesTellWhereABeadLies) {
    polygon::Region r;
    r.z = 1, r.height = 0.2, r.walls = 2;
    r.loops = test::loop({{0, 0}, {40, 0}, {40, 20}, {0, 20}});
    r.area = 800;
    r.areas.push_back({AreaKind::sparse, test::loop({{0.8, 0.8}, {20, 0.8}, {20, 19.2}, {0.8, 19.2}}), 0.7, 3, {}});
    Notes notes;
    const auto paths = fill(r, {.bead_width = kWidth}, notes);
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
    EXPECT_NEAR(of(Feature::solid) * kWidth, 19.2 * 18.4, 8);
    EXPECT_NEAR(of(Feature::infill) * kWidth, 19.2 * 18.4 * 0.4 / 3 + 0.4 * 37, 15);
}

} // namespace
} // namespace filum::hollow
