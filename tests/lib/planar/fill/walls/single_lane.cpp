#include "fill/walls/single_lane.hpp"

#include "../pattern_check.hpp"
#include "fill/fill.hpp"
#include "fill/spiral.hpp"

namespace filum::fill {

using namespace walls;

namespace {

using namespace test;

Loops with(const Loops& a, const Loops& b) { return regions_of(polygon::unite(a, b)).at(0); }
Loops neck() { return with(with(rectangle(0, 0, 5, 5), rectangle(11, 0, 16, 5)), rectangle(5, 2, 11, 2.3)); }
Loops fin(double from, double to) { return with(rectangle(0, 0, 5, 5), rectangle(5, 2, from, to)); }

struct Filled {
    std::vector<Curve> curves;
    Notes notes;
};
Filled filled(const Loops& area, Thin thin) {
    polygon::Region r;
    r.loops = area;
    r.area = polygon::signed_area(area);
    Options o;
    o.thin = thin;
    Filled out;
    out.curves = fill(r, o, out.notes).curves;
    return out;
}

// Where a lane begins beside a thin wall its bead is narrow, for 2 mm at most.
Notes besides_narrow(Notes notes) {
    std::erase_if(notes, [](const Note& n) { return n.code == NoteCode::bead_too_thin && n.amount < 2.5; });
    return notes;
}

double length_of_all(const std::vector<Curve>& curves) {
    double sum = 0;
    for (const auto& c : curves) sum += length_of(c);
    return sum;
}

TEST(SingleLane, ANeckBetweenFatPartsIsPassedOnce) {
    const auto lanes = filled(neck(), Thin::lanes), single = filled(neck(), Thin::single);
    ASSERT_EQ(single.curves.size(), 1U);
    EXPECT_TRUE(lanes.curves[0].closed);
    EXPECT_FALSE(single.curves[0].closed);
    EXPECT_TRUE(besides_narrow(single.notes).empty());
    EXPECT_NEAR(length_of_all(lanes.curves) - length_of_all(single.curves), 5.6, 0.4);
    EXPECT_EQ(crossings(single.curves), 0U);
    EXPECT_NEAR(laid(single.curves), laid(lanes.curves), 0.01 * laid(lanes.curves));
    // one end at either side of the neck
    const double x = single.curves[0].points.front().x, y = single.curves[0].points.back().x;
    EXPECT_NEAR(std::min(x, y), 5.2, 0.3);
    EXPECT_NEAR(std::max(x, y), 10.8, 0.3);
    // and its bead fills it
    const Curve& c = single.curves[0];
    for (std::size_t i = 0; i < c.points.size(); ++i)
        if (c.points[i].x > 6 && c.points[i].x < 10) {
            EXPECT_NEAR(c.points[i].y, 2.15, 0.01);
            EXPECT_NEAR(c.width_at(i), 0.3, 0.01);
        }
}

TEST(SingleLane, ADeadEndIsWhereTheCurveEnds) {
    const auto single = filled(fin(14, 2.3), Thin::single);
    ASSERT_EQ(single.curves.size(), 1U);
    const Curve& c = single.curves[0];
    EXPECT_FALSE(c.closed);
    EXPECT_NEAR(std::max(c.points.front().x, c.points.back().x), 13.85, 0.05);
    EXPECT_EQ(crossings(single.curves), 0U);
    EXPECT_GT(coverage(fin(14, 2.3), single.curves, 0.04), 0.97);
}

TEST(SingleLane, OnlyTheLongestOfSeveralIsPassedOnce) {
    const Loops area = with(fin(14, 2.3), rectangle(4, 4, 9, 4.3));
    const auto single = filled(area, Thin::single);
    ASSERT_EQ(single.curves.size(), 1U);
    const Notes notes = besides_narrow(single.notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::wall_doubled);
    EXPECT_NEAR(notes[0].amount, 4, 0.4);
}

TEST(SingleLane, ShortAndThickWallsStayAsTheyAre) {
    for (const auto& area : {rectangle(0, 0, 5, 5), fin(6, 2.3), fin(14, 2.9)}) {
        const auto lanes = filled(area, Thin::lanes), single = filled(area, Thin::single);
        EXPECT_TRUE(same(lanes.curves, single.curves));
    }
}

// Walls whose lanes would be below the least width (0.1): there and back on one line, half as wide as they are.
TEST(StackLanes, HairWallsArePassedTwiceOnTheirMiddle) {
    for (const double thickness : {0.08, 0.15, 0.18}) {
        const Loops areas[] = {fin(14, 2 + thickness), with(with(rectangle(0, 0, 5, 5), rectangle(11, 0, 16, 5)),
                                                            rectangle(5, 2, 11, 2 + thickness))};
        for (const Loops& area : areas) {
            polygon::Region r;
            r.loops = area;
            r.area = polygon::signed_area(area);
            Options o;
            Notes notes, plain;
            const double lanes = laid(fill(r, o, plain).curves);
            EXPECT_EQ(plain.size(), 1U);
            o.thin = Thin::half_height;
            const auto paths = fill(r, o, notes);
            for (const Note& n : notes) EXPECT_LT(n.amount, 1.5) << thickness; // mm: a link where the box narrows
            ASSERT_EQ(paths.curves.size(), 1U);
            EXPECT_TRUE(paths.curves[0].closed);
            EXPECT_EQ(crossings(paths.curves), 0U);
            EXPECT_NEAR(laid(paths.curves), lanes, 0.02 * lanes);
            ASSERT_EQ(paths.stacked.size(), 1U);
            for (const Vec2 p : paths.stacked[0]) EXPECT_NEAR(p.y, 2 + thickness / 2, 0.003);
            const Curve& c = paths.curves[0];
            std::size_t passes = 0;
            for (std::size_t i = 0; i < c.points.size(); ++i) {
                const Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
                passes += (a.x < 8) != (b.x < 8) ? 1 : 0;
                if (a.x < 6 || a.x > 10) continue;
                EXPECT_NEAR(a.y, 2 + thickness / 2, 0.003);
                EXPECT_NEAR(c.width_at(i), thickness / 2, 0.003);
            }
            EXPECT_EQ(passes, 2U);
        }
    }
}

TEST(StackLanes, ThickerWallsKeepTheirLanes) {
    for (const auto& area : {rectangle(0, 0, 5, 5), fin(14, 2.3)}) {
        polygon::Region r;
        r.loops = area;
        r.area = polygon::signed_area(area);
        Options o;
        o.thin = Thin::half_height;
        Notes notes;
        const auto paths = fill(r, o, notes);
        EXPECT_TRUE(paths.stacked.empty());
        EXPECT_TRUE(same(paths.curves, filled(area, Thin::lanes).curves));
    }
}

TEST(SingleLane, RandomRegionsKeepOneSoundCurve) {
    std::size_t opened = 0;
    for (unsigned seed = 0; seed < 40; ++seed)
        for (const auto& area : random_regions(seed)) {
            if (polygon::signed_area(area) < 2) continue;
            const auto lanes = filled(area, Thin::lanes), single = filled(area, Thin::single);
            EXPECT_EQ(single.curves.size(), lanes.curves.size()) << seed;
            expect_sound(single.curves);
            EXPECT_EQ(crossings(single.curves), 0U) << seed;
            EXPECT_LT(length_of_all(single.curves), length_of_all(lanes.curves) + 0.1) << seed;
            EXPECT_NEAR(laid(single.curves) / laid(lanes.curves), 1, 0.03) << seed;
            opened += single.curves[0].closed ? 0 : 1;
        }
    EXPECT_GT(opened, 2U);
}

} // namespace
} // namespace filum::fill
