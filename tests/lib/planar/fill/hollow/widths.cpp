// Regions whose walls, solid parts and sparse lines have widths of their own.
#include "base/error.hpp"
#include "cases.hpp"

#include <map>

namespace filum::fill::hollow {
namespace {

using polygon::AreaKind;
using polygon::Loops;
using toolpath::Feature;

struct RoleWidths {
    double outer = kBead, inner = kBead, lines = kBead, solid = kBead; // mm
    std::uint32_t walls = 2;
};

// The region as `skins` leaves it: a zone for all of it, and a sparse area where `sparse` lies inside the walls.
polygon::Region as_planned(polygon::Region r, const RoleWidths& w, const Loops& sparse) {
    const bool apart = w.inner != w.outer;
    r.walls = apart ? 1 : w.walls;
    polygon::Area zone{AreaKind::zone, r.loops, 0, 0, {}};
    zone.walls = w.walls - r.walls;
    zone.width = w.inner;
    zone.solid = w.solid;
    r.areas.push_back(zone);
    const double depth = w.outer + (w.walls - 1) * w.inner;
    const Loops within = polygon::intersect(polygon::offset(r.loops, -depth), sparse);
    if (within.empty()) return r;
    polygon::Area area{AreaKind::sparse, within, 0.7, 2.5, polygon::InfillPattern::rows};
    area.width = w.lines;
    r.areas.push_back(area);
    return r;
}

polygon::Region plate(double x, double y) {
    polygon::Region r;
    r.z = r.height = 0.2;
    r.loops = test::rectangle(0, 0, x, y);
    r.area = x * y;
    return r;
}

// The share of the length of each feature whose width is near `wanted`.
std::map<Feature, double> shares(const toolpath::RegionPaths& paths, const std::map<Feature, double>& wanted) {
    std::map<Feature, double> near, all;
    for (const auto& c : paths.curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const std::size_t next = (i + 1) % c.points.size();
            const auto at = wanted.find(c.feature[i]);
            if (at == wanted.end()) continue;
            const double length = geom::distance(c.points[i], c.points[next]);
            const double width = (c.width_at(i) + c.width_at(next)) / 2;
            all[c.feature[i]] += length;
            if (std::abs(width - at->second) < 0.06 * at->second) near[c.feature[i]] += length;
        }
    for (auto& [feature, length] : near) length /= all[feature];
    return near;
}

TEST(HollowWidths, EveryRoleHasItsWidth) {
    const RoleWidths w{0.42, 0.5, 0.6, 0.38, 3};
    for (const bool hollow : {false, true}) {
        const polygon::Region r = as_planned(plate(60, 50), w, hollow ? test::rectangle(0, 0, 60, 50) : Loops{});
        Notes notes;
        const auto paths = fill(r, {.bead_width = w.outer}, notes);
        ASSERT_EQ(paths.curves.size(), 1U);
        const auto near = shares(paths, {{Feature::outer_wall, 0.42},
                                         {Feature::wall, 0.5},
                                         {hollow ? Feature::infill : Feature::solid, hollow ? 0.6 : 0.38}});
        ASSERT_EQ(near.size(), 3U);
        for (const auto& [feature, share] : near) EXPECT_GT(share, 0.85) << hollow << " " << static_cast<int>(feature);
        if (!hollow) {
            EXPECT_NEAR(test::laid(paths.curves), r.area, 0.01 * r.area);
        }
    }
}

// A stream may hold any widths: beads that taper over a factor of millions would take all memory.
TEST(HollowWidths, WidthsThatCannotBeJoinedAreRefused) {
    for (const auto& [solid, refused] : {std::pair{1e-4, true}, {40.0, true}, {0.2, false}, {2.0, false}}) {
        const polygon::Region r = as_planned(plate(60, 50), {0.38, 0.4, 0.4, solid, 2}, {});
        Notes notes;
        if (refused)
            EXPECT_THROW(fill(r, {.bead_width = 0.38}, notes), Error) << solid;
        else
            EXPECT_NO_THROW(fill(r, {.bead_width = 0.38}, notes)) << solid;
    }
}

TEST(HollowWidths, OneClosedCurveThatDoesNotCrossItself) {
    std::size_t more = 0, all = 0;
    for (const Case& c : random_cases(60)) {
        const RoleWidths w{kBead, 0.34 + 0.03 * (c.seed % 7), 0.36 + 0.04 * (c.seed % 6), 0.36 + 0.03 * (c.seed % 5),
                           1 + c.seed % 3};
        const Loops sparse = c.seed % 4 == 0 ? Loops{} : test::disc({2.0 - c.seed % 5, 1}, 6 + c.seed % 9);
        more += sound_curves({as_planned(c.region, w, sparse), c.seed}) > 1 ? 1 : 0;
        ++all;
    }
    EXPECT_LE(more, all / 40); // where a corner is too small for a window; a note reports it
}

} // namespace
} // namespace filum::fill::hollow
