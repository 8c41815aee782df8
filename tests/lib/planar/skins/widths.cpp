// Beads of roles with widths of their own.
#include "polygon/clip.hpp"
#include "skins/skins.hpp"

#include <gtest/gtest.h>

namespace filum::skins {
namespace {

using polygon::AreaKind;
using polygon::Loops;
using polygon::Region;

Loops rectangle(double x, double y) {
    Loops out;
    out.add(std::vector<geom::Vec2>{{0, 0}, {x, 0}, {x, y}, {0, y}});
    return out;
}

std::vector<Region> box(std::uint32_t layers) {
    std::vector<Region> out;
    for (std::uint32_t i = 0; i < layers; ++i) {
        Region r;
        r.id = r.layer = i;
        r.height = 0.2;
        r.z = 0.2 * (i + 1);
        r.loops = rectangle(40, 30);
        r.area = 1200;
        r.box = polygon::bounds(r.loops[0]);
        out.push_back(std::move(r));
    }
    return out;
}

const polygon::Area* area_of(const Region& r, AreaKind kind) {
    for (const auto& a : r.areas)
        if (a.kind == kind) return &a;
    return nullptr;
}

TEST(SkinWidths, AZoneHoldsTheWidthsInsideTheOuterWall) {
    Options o;
    o.walls = 3;
    o.inner_width = 0.5;
    o.infill_width = 0.6;
    o.solid_width = 0.45;
    auto part = box(20);
    Facts facts;
    EXPECT_TRUE(skins(part, o, {}, facts).empty());
    for (const Region& r : part) {
        EXPECT_EQ(r.walls, 1U);
        const auto* zone = area_of(r, AreaKind::zone);
        ASSERT_NE(zone, nullptr) << r.layer;
        EXPECT_EQ(zone->walls, 2U);
        EXPECT_EQ(zone->width, 0.5);
        EXPECT_EQ(zone->solid, 0.45);
        if (const auto* sparse = area_of(r, AreaKind::sparse)) {
            EXPECT_EQ(sparse->width, 0.6);
            const double depth = 0.4 + 2 * 0.5; // of the walls
            EXPECT_NEAR(polygon::signed_area(sparse->loops), (40 - 2 * depth) * (30 - 2 * depth), 2);
        }
    }
    ASSERT_NE(area_of(part[10], AreaKind::sparse), nullptr);
    double spacing = 0;
    for (const Fact& f : facts)
        if (f.name == "infill-spacing") spacing = f.value;
    EXPECT_GT(spacing, 0.6 / 0.15); // endless lines; ends of lines follow the walls
    EXPECT_LT(spacing, 1.3 * 0.6 / 0.15);
}

TEST(SkinWidths, EqualWidthsChangeNothing) {
    Options plain, same;
    same.inner_width = same.infill_width = same.solid_width = plain.bead_width;
    auto one = box(12), two = box(12);
    Facts facts;
    skins(one, plain, {}, facts);
    skins(two, same, {}, facts);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].walls, two[i].walls);
        ASSERT_EQ(one[i].areas.size(), two[i].areas.size());
        for (std::size_t k = 0; k < one[i].areas.size(); ++k) {
            EXPECT_EQ(one[i].areas[k].width, two[i].areas[k].width);
            EXPECT_EQ(one[i].areas[k].loops.points, two[i].areas[k].loops.points);
        }
    }
}

TEST(SkinWidths, ARegionsOwnWidthHoldsThroughout) {
    Options o;
    o.inner_width = 0.5;
    o.bottom = 0;
    auto part = box(12);
    part[0].width = 0.6;
    Facts facts;
    skins(part, o, {}, facts);
    EXPECT_EQ(area_of(part[0], AreaKind::zone), nullptr);
    EXPECT_NE(area_of(part[1], AreaKind::zone), nullptr);
    const auto* sparse = area_of(part[0], AreaKind::sparse);
    ASSERT_NE(sparse, nullptr);
    EXPECT_EQ(sparse->width, 0);
    EXPECT_NEAR(polygon::signed_area(sparse->loops), (40 - 2.4) * (30 - 2.4), 2);
}

TEST(SkinWidths, AModifierWithABeadWidthHasItThroughout) {
    Options o;
    o.inner_width = 0.5;
    o.solid_width = 0.45;
    const Options m = modified(o, "bead-width=0.8");
    EXPECT_EQ(inner_width(m), 0.8);
    EXPECT_EQ(infill_width(m), 0.8);
    EXPECT_EQ(solid_width(m), 0.8);
    EXPECT_EQ(inner_width(modified(o, "walls=4")), 0.5);
}

} // namespace
} // namespace filum::skins
