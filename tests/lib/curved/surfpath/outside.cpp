// Turns beyond the rims.
#include "surfpath/outside.hpp"

#include "../../shapes/surface/grid.hpp"
#include "base/error.hpp"
#include "geom/angle.hpp"
#include "plans.hpp"
#include "surfpath/surfpath.hpp"

#include <gtest/gtest.h>

namespace filum::surfpath {
namespace {

surface::Sheet flat_plate() {
    Notes notes;
    return {surface::connect(surface::flat_grid(30, 20, 6, 4), notes), {}, {}};
}

Options outside_by(Algorithm a, double depth) {
    Options out{.algorithm = a};
    out.turn_outside = depth;
    return out;
}

TEST(Outside, OnlyRowsTurnThere) {
    EXPECT_TRUE(flange(flat_plate(), outside_by(Algorithm::fexa, 2)).has_value());
    EXPECT_FALSE(flange(flat_plate(), outside_by(Algorithm::hybrid, 2)).has_value());
    EXPECT_FALSE(flange(flat_plate(), outside_by(Algorithm::fina, 0)).has_value());
    EXPECT_THROW(flange(flat_plate(), outside_by(Algorithm::fina, 0.5)), Error);
}

// The plan with turns up to `depth` mm outside, told.
Plan planned(const surface::Sheet& sheet, Options o, double depth) {
    o.turn_outside = depth;
    const Flange f = flange(sheet, o).value();
    o = on_flange(f, o);
    Plan out = plan_paths(f.sheet, o);
    thread(f.sheet.surface, out);
    finish(f.sheet.surface, out, o);
    report_trims(f, depth, out);
    return out;
}

Options rows_at(double degrees) {
    Options out{.algorithm = Algorithm::field};
    out.follow.angle = 1;
    out.follow.turn = geom::radians(degrees);
    return out;
}

TEST(Outside, ALineOverTheRimIsTrimmedWhereItCrosses) {
    const Flange f = flange(flat_plate(), outside_by(Algorithm::fina, 4)).value();
    Plan p;
    const surface::Segment begin = surface::nearest(f.sheet.surface, {15, 10, 0});
    const surface::Segment end = surface::nearest(f.sheet.surface, {33, 10, 0});
    p.strokes.push_back({{{{{{begin.triangle, begin.a}, {end.triangle, end.a}}, false}, false}}});
    thread(f.sheet.surface, p);
    const Trims found = trims(p, f.part);
    ASSERT_EQ(found.all.size(), 1U);
    EXPECT_NEAR(found.all[0].at.x, 30, 1e-9);
    EXPECT_NEAR(found.all[0].way, 15, 1e-9);
    EXPECT_NEAR(found.outside, 3, 1e-9);
}

TEST(Outside, APlateIsCoveredWithoutATurnOnIt) {
    for (const double angle : {0.0, 30.0, 45.0}) {
        const Plan on = planned(flat_plate(), rows_at(angle), 6);
        EXPECT_EQ(fact(on, "cuts"), 0);
        EXPECT_LT(fact(on, "uncovered"), 0.005 * 600) << angle;
        EXPECT_LT(fact(on, "laid-twice"), 0.01 * 600) << angle;
        EXPECT_GT(fact(on, "outside"), 50);
        EXPECT_EQ(static_cast<int>(fact(on, "trims")) % 2, 0); // it begins and ends outside
    }
}

TEST(Outside, RowsThatCoverNothingOfThePartAreLeftOut) {
    const Plan on = planned(flat_plate(), rows_at(0), 8); // 16 mm of flange above and below 20 mm of part
    EXPECT_LT(fact(on, "rows"), 23);
}

// The second one ends in a vertex of the rim, in a triangle that has no side there.
TEST(Outside, SourcesGoOnOverTheFlange) {
    for (const auto& [rise, up] : {std::pair(0.0, 7.0), std::pair(0.2, 10.0)}) {
        surface::Sheet sheet = flat_plate();
        for (const surface::Segment& g : surface::section(sheet.surface, {{-rise, 1, 0}, up}))
            sheet.sources.segments.push_back(g);
        const Flange f = flange(sheet, outside_by(Algorithm::fina, 4)).value();
        double least = 0, most = 0;
        for (const surface::Segment& g : f.sheet.sources.segments)
            for (const Vec3& p : {g.a, g.b}) {
                EXPECT_NEAR(p.y, up + rise * p.x, 1e-9);
                least = std::min(least, p.x);
                most = std::max(most, p.x);
            }
        EXPECT_NEAR(least, -4, 1e-9);
        EXPECT_NEAR(most, 34, 1e-9);
    }
}

// A seed that divides a face narrower above and below than in its middle: rows are those of the distance from the seed,
// and not led towards the flange's own rim, where they would bend beside its corners.
TEST(Outside, RowsStayStraightWhereRimsComeNearer) {
    Notes notes;
    surface::Sheet sheet{surface::connect(surface::grid(30, 40, 24, 32,
                                                        [](geom::Vec2 p) {
                                                            const double y = p.y - 20, half = 15 - 5 * y * y / 400;
                                                            return Vec3{(p.x / 15 - 1) * half, y, 0};
                                                        }),
                                          notes),
                         {},
                         {}};
    for (const surface::Segment& g : surface::section(sheet.surface, {{0, 1, 0}, 0}))
        sheet.sources.segments.push_back(g);
    const Plan on = planned(sheet, {.algorithm = Algorithm::fina}, 5);
    EXPECT_EQ(fact(on, "tight-turns"), 0);
    EXPECT_LT(fact(on, "uncovered"), 1);
    for (const Stroke& stroke : on.strokes)
        for (const Section& piece : stroke.sections)
            for (const Place& p : piece.line.places)
                if (std::abs(p.point.x) < 9) {
                    EXPECT_NEAR(std::abs(p.point.y) - std::floor(std::abs(p.point.y)), 0.5, 1e-6) << p.point.x;
                }
}

} // namespace
} // namespace filum::surfpath
