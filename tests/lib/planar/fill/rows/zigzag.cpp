#include "fill/rows/zigzag.hpp"

#include "../pattern_check.hpp"
#include "fill/rows/maze.hpp"

namespace filum::fill {

using namespace rows;

namespace {

using namespace test;

// (the rings may be moved past an acute tip, by less than a third of a bead)
void expect_one_closed_curve(const Loops& region, double angle, const std::string& name) {
    Notes notes;
    const auto curves = zigzag(region, {.angle = angle}, notes);
    expect_sound(curves);
    ASSERT_EQ(curves.size(), 1U) << name << " at " << angle;
    EXPECT_TRUE(curves[0].closed);
    EXPECT_EQ(crossings(curves), 0U) << name << " at " << angle;
    EXPECT_LT(farthest_outside(region, curves), 0.12) << name << " at " << angle;
}

TEST(Zigzag, IsOneClosedCurveThatNeverCrossesItself) {
    for (const auto& [name, region] : hard_regions())
        for (const double angle : {0.0, 0.6, std::numbers::pi / 2}) expect_one_closed_curve(region, angle, name);
}

TEST(Zigzag, IsOneClosedCurveInRandomRegions) {
    for (unsigned seed = 0; seed < 30; ++seed)
        for (const auto& region : random_regions(seed))
            if (polygon::signed_area(region) > 0.5) expect_one_closed_curve(region, 0.1 * seed, std::to_string(seed));
}

TEST(Zigzag, NoLinkCrossesASlot) {
    for (const double slot : {0.01, 0.1, 0.3}) {
        Loops area = rectangle(0, 0, 12, 9);
        for (int k = 1; k < 6; ++k) area = polygon::subtract(area, rectangle(2 * k, 1, 2 * k + slot, 9.5));
        expect_one_closed_curve(regions_of(area).at(0), 0, "slots of " + std::to_string(slot));
        for (const double angle : {0.0, 0.5, 1.5708}) {
            Notes notes;
            const auto curves = zigzag(regions_of(area).at(0), {.angle = angle}, notes);
            for (const auto& c : curves)
                for (std::size_t i = 0; i < c.points.size(); ++i)
                    for (int k = 1; k < 6; ++k) {
                        const Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
                        EXPECT_FALSE(geom::cross_properly(a, b, {2 * k + slot / 2, 1}, {2 * k + slot / 2, 9}));
                    }
        }
    }
}

TEST(Zigzag, LaysTheRegionsArea) {
    for (const auto& [name, region] : hard_regions())
        for (const double angle : {0.0, 0.6}) {
            Notes notes;
            const auto curves = zigzag(region, {.angle = angle}, notes);
            const double area = polygon::signed_area(region);
            EXPECT_NEAR(laid(curves) / area, 1, 0.07) << name << " at " << angle;
            EXPECT_GT(coverage(region, curves), 0.94) << name << " at " << angle;
        }
}

TEST(Zigzag, RowsFitARectangle) {
    for (double height = 4; height < 8; height += 0.31) {
        Notes notes;
        const auto region = rectangle(0, 0, 40, height);
        const auto curves = zigzag(region, {}, notes);
        ASSERT_EQ(curves.size(), 1U);
        EXPECT_GT(coverage(region, curves), 0.99) << height;
        EXPECT_NEAR(laid(curves) / (40 * height), 1, 0.012) << height;
        EXPECT_TRUE(notes.empty());
    }
}

TEST(Zigzag, MostOfItRunsAlongTheRows) {
    Notes notes;
    const double angle = 0.4;
    const auto curves = zigzag(disc({0, 0}, 8), {.angle = angle}, notes);
    double along = 0;
    const Vec2 d{std::cos(angle), std::sin(angle)};
    const auto& p = curves.at(0).points;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 s = p[(i + 1) % p.size()] - p[i];
        if (std::abs(geom::cross(s, d)) < 0.05 * geom::norm(s)) along += geom::norm(s);
    }
    EXPECT_GT(along, 0.8 * length_of(curves[0]));
}

TEST(Zigzag, IsRepeatable) {
    Notes notes;
    for (const auto& region : random_regions(5))
        EXPECT_TRUE(same(zigzag(region, {}, notes), zigzag(region, {}, notes)));
}

TEST(Zigzag, TakesWhateverIsTooSmall) {
    for (const double size : {0.002, 0.05, 0.3, 0.39, 0.41, 0.79}) {
        Notes notes;
        expect_sound(zigzag(rectangle(0, 0, size, size), {}, notes));
        expect_sound(zigzag(rectangle(0, 0, 10, size), {}, notes));
        expect_sound(zigzag(rectangle(0, 0, size, 10), {}, notes));
    }
}

TEST(RingedZigzag, LinkedIsOneClosedCurveThatNeverCrossesItself) {
    const auto check = [](const Loops& region, int rings, double angle, const std::string& name) {
        Notes notes;
        const auto curves = zigzag(region, {.angle = angle, .rings = rings}, notes);
        expect_sound(curves);
        ASSERT_EQ(curves.size(), 1U) << name;
        EXPECT_TRUE(curves[0].closed);
        EXPECT_EQ(crossings(curves), 0U) << name;
        EXPECT_LT(farthest_outside(region, curves), 0.12) << name; // acute tips may be moved a little
    };
    for (const auto& [name, region] : hard_regions())
        for (const int rings : {1, 2, 4}) check(region, rings, 0.3, name);
    for (unsigned seed = 0; seed < 15; ++seed)
        for (const auto& region : random_regions(seed))
            if (polygon::signed_area(region) > 0.5) check(region, 2, 0.1 * seed, std::to_string(seed));
}

TEST(RingedZigzag, LaysTheRegionsArea) {
    for (const auto& [name, region] : hard_regions())
        for (const bool linked : {true, false}) {
            Notes notes;
            const auto curves = zigzag(region, {.angle = 0.5, .rings = 2, .linked = linked}, notes);
            EXPECT_EQ(crossings(curves), 0U) << name;
            EXPECT_NEAR(laid(curves) / polygon::signed_area(region), 1, 0.12) << name; // acute tips are overfilled
            EXPECT_GT(coverage(region, curves), 0.94) << name;
        }
}

TEST(RingedZigzag, UnlinkedIsRingsAndOneCore) {
    Notes notes;
    const auto region = rectangle(0, 0, 12, 8);
    const auto curves = zigzag(region, {.rings = 3, .linked = false}, notes);
    ASSERT_EQ(curves.size(), 4U);
    for (int k = 0; k < 3; ++k)
        for (const Vec2 p : curves[static_cast<std::size_t>(k)].points)
            EXPECT_NEAR(distance_to_outline(region, p), (k + 0.5) * 0.4, 0.02);
    for (const Vec2 p : curves[3].points) EXPECT_GT(distance_to_outline(region, p), 3.4 * 0.4);
}

TEST(RingedZigzag, CoreRunsAtTheAngle) {
    const double angle = 0.7;
    const Vec2 d{std::cos(angle), std::sin(angle)};
    Notes notes;
    const auto core = zigzag(disc({0, 0}, 9), {.angle = angle, .rings = 2, .linked = false}, notes).back();
    double along = 0;
    for (std::size_t i = 0; i < core.points.size(); ++i) {
        const Vec2 s = core.points[(i + 1) % core.points.size()] - core.points[i];
        if (std::abs(geom::cross(s, d)) < 0.05 * geom::norm(s)) along += geom::norm(s);
    }
    EXPECT_GT(along, 0.75 * length_of(core));
}

TEST(RingedZigzag, TakesWhateverIsTooSmall) {
    for (const double size : {0.002, 0.05, 0.3, 0.39, 0.41, 0.79, 1.7, 2.1})
        for (const bool linked : {true, false}) {
            Notes notes;
            expect_sound(zigzag(rectangle(0, 0, size, size), {.rings = 2, .linked = linked}, notes));
            expect_sound(zigzag(rectangle(0, 0, 10, size), {.rings = 2, .linked = linked}, notes));
        }
}

TEST(RingedZigzag, IsRepeatable) {
    Notes notes;
    for (const auto& region : random_regions(11))
        EXPECT_TRUE(same(zigzag(region, {.rings = 2}, notes), zigzag(region, {.rings = 2}, notes)));
}

TEST(Maze, IsOneCorridorTwoBeadsWide) {
    // no circle wider than a row fits anywhere but at doors, and the area is all there
    const auto region = rectangle(0, 0, 12, 9.3);
    const auto corridor = maze(region, 0.4, 0.8);
    EXPECT_NEAR(polygon::signed_area(corridor), polygon::signed_area(region), 0.2);
    EXPECT_EQ(polygon::split(corridor).part.size(), 1U);
    EXPECT_EQ(corridor.size(), 1U) << "walls that stand free would make holes";
    EXPECT_FALSE(polygon::offset(corridor, -0.38).empty());
    EXPECT_LT(polygon::signed_area(polygon::offset(corridor, -0.5)), 0.5);
}

} // namespace
} // namespace filum::fill
