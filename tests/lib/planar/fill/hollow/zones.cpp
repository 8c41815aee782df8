// Regions with zones that have walls and beads of their own.
#include "fill/hollow/hollow.hpp"

#include "cases.hpp"

namespace filum::fill::hollow {
namespace {

using polygon::AreaKind;
using polygon::Loops;
using toolpath::Feature;

struct Zone {
    Loops where;
    std::uint32_t walls;
    double width; // mm
};

void add_zone(polygon::Region& r, const Zone& zone) {
    polygon::Area a{AreaKind::zone, zone.where, 0, 0, {}};
    a.walls = zone.walls;
    a.width = zone.width;
    r.areas.push_back(a);
}

void add_sparse(polygon::Region& r, const Loops& where, double spacing) {
    if (!where.empty()) r.areas.push_back({AreaKind::sparse, where, 0.7, spacing, polygon::InfillPattern::rows});
}

// Random regions, cut by a disc into what has other walls (even seeds) or other beads (odd ones).
std::vector<Case> zoned_cases(unsigned seeds) {
    auto out = random_cases(seeds);
    for (auto& [r, seed] : out) {
        const Loops disc = test::disc({4.0 - seed % 9, 3.0 - seed % 7}, 5 + seed % 4);
        const Loops in = polygon::intersect(r.loops, disc), beside = polygon::subtract(r.loops, disc);
        const bool mixed = seed % 2 == 1;
        const double other = mixed ? (seed % 4 == 1 ? 0.6 : 0.3) : kBead;
        const Zone inner{in, mixed ? seed % 3 : 0, other}, outer{beside, (mixed ? 0 : 1) + seed / 2 % 3, kBead};
        for (const Zone* z : {&inner, &outer}) {
            if (z->where.empty()) continue;
            if (z->walls > 0 || z->width != kBead) add_zone(r, *z);
            const Loops within = polygon::offset(r.loops, -(kBead + z->walls * z->width));
            if (seed % 5 != 0) // else solid
                add_sparse(r, polygon::intersect(within, polygon::offset(z->where, -(z->walls * z->width))),
                           1.5 + 0.2 * (seed % 10));
        }
    }
    return out;
}

} // namespace

TEST(HollowZones, OneClosedCurveThatDoesNotCrossItself) {
    std::size_t more = 0, all = 0;
    for (const Case& c : zoned_cases(60)) {
        ++all;
        more += sound_curves(c) > 1 ? 1 : 0;
    }
    EXPECT_LE(more, all / 80); // where a corner between two pieces is too small for a window: told
}

TEST(HollowZones, WhatIsSolidIsCovered) {
    double uncovered = 0, twice = 0, all = 0;
    for (const Case& c : zoned_cases(20)) {
        Notes notes;
        const auto paths = fill(c.region, {.bead_width = kBead}, notes);
        const Loops solid = solid_part(c.region);
        const double area = polygon::signed_area(solid);
        uncovered += area * (1 - test::coverage(solid, paths.curves));
        all += area;
        if (c.seed % 5 == 0) twice += test::laid(paths.curves) - c.region.area;
    }
    EXPECT_LT(uncovered, 0.02 * all);
    EXPECT_LT(twice, 0.02 * all);
}

// A plate of 40 x 20 mm, other walls left of its middle.
TEST(HollowZones, WallsAreAsManyAsTheZoneSays) {
    const Loops left = test::rectangle(0, 0, 20, 20), right = test::rectangle(20, 0, 40, 20);
    for (const auto& [walls_left, walls_right] : {std::pair{1, 3}, {2, 3}, {3, 2}, {1, 2}}) {
        polygon::Region r;
        r.z = r.height = 0.2;
        r.loops = test::rectangle(0, 0, 40, 20);
        r.area = 800;
        const int fewest = std::min(walls_left, walls_right);
        r.walls = static_cast<std::uint32_t>(fewest);
        for (const auto& [where, walls] : {std::pair{left, walls_left}, {right, walls_right}}) {
            const int more = walls - fewest;
            if (more > 0) add_zone(r, {where, static_cast<std::uint32_t>(more), kBead});
            add_sparse(
                r,
                polygon::intersect(polygon::offset(r.loops, -(walls * kBead)), polygon::offset(where, -(more * kBead))),
                3);
        }
        Notes notes;
        const auto paths = fill(r, {.bead_width = kBead}, notes);
        ASSERT_EQ(paths.curves.size(), 1U);
        const auto& c = paths.curves[0];
        // how often lines across the lower edge meet walls: the median of some, as a joint may lie on one
        const auto walls_at = [&](double x) {
            int n = 0;
            for (std::size_t i = 0; i < c.points.size(); ++i) {
                const geom::Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
                const bool wall = c.feature[i] == Feature::wall || c.feature[i] == Feature::outer_wall;
                if (wall && geom::cross_properly({x, -1}, {x, 4}, a, b)) ++n;
            }
            return n;
        };
        const auto median = [&](double from) {
            std::vector<int> n;
            for (int k = 0; k < 15; ++k) n.push_back(walls_at(from + 0.97 * k));
            std::ranges::sort(n);
            return n[7];
        };
        EXPECT_EQ(median(3.03), walls_left);
        EXPECT_EQ(median(23.03), walls_right);
    }
}

TEST(HollowZones, BeadsAreAsWideAsTheZoneSays) {
    for (const double other : {0.25, 0.6, 0.8}) {
        polygon::Region r;
        r.z = r.height = 0.2;
        r.loops = test::rectangle(0, 0, 40, 20);
        r.area = 800;
        const Loops left = test::rectangle(0, 0, 20, 20), right = test::rectangle(20, 0, 40, 20);
        r.walls = 1;
        add_zone(r, {left, 2, other});
        add_zone(r, {right, 2, kBead});
        Notes notes;
        const auto paths = fill(r, {.bead_width = kBead}, notes);
        ASSERT_EQ(paths.curves.size(), 1U);
        double wrong = 0, all = 0;
        const auto& c = paths.curves[0];
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const geom::Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
            // the outer wall is the same everywhere
            const double length = geom::distance(a, b);
            const double expected = a.x < 20 && c.feature[i] != Feature::outer_wall ? other : kBead;
            all += length;
            wrong += std::abs(c.width_at(i) - expected) > 0.3 * expected ? length : 0;
        }
        EXPECT_LT(wrong, 0.05 * all) << other;
        EXPECT_NEAR(test::laid(paths.curves), r.area, 0.015 * r.area) << other;
        EXPECT_GT(test::coverage(r.loops, paths.curves), 0.98) << other;
    }
}

} // namespace filum::fill::hollow
