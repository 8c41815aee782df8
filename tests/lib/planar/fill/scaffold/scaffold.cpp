#include "fill/scaffold/scaffold.hpp"

#include "../pattern_check.hpp"
#include "base/error.hpp"
#include "fill/fill.hpp"
#include "fill/scaffold/strand_bead.hpp"
#include "fill/scaffold/strand_walk.hpp"
#include "polygon/inset.hpp"
#include "polygon/stretches.hpp"

namespace filum::fill {

using namespace scaffold;

namespace {

using namespace test;

Loops yoke() { return regions_of(polygon::subtract(rectangle(0, 0, 20, 20), rectangle(6, 6, 14, 21))).at(0); }

double distance_to(const std::vector<Curve>& curves, Vec2 p) {
    double best = 1e300;
    for (const auto& c : curves)
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
            best = std::min(best, geom::point_segment_distance(c.points[i], c.points[(i + 1) % c.points.size()], p));
    return best;
}

// The places along the normal of the layer's straight strands, sorted.
std::vector<double> strand_lines(const Curve& c, double angle, double longest) {
    std::vector<double> out;
    const Vec2 along{std::cos(angle), std::sin(angle)};
    for (std::size_t i = 0; i + 1 < c.points.size(); ++i) {
        const Vec2 d = c.points[i + 1] - c.points[i];
        if (std::abs(geom::dot(along, d)) > longest && std::abs(geom::cross(along, d)) < 1e-6)
            out.push_back(geom::cross(along, c.points[i]));
    }
    std::sort(out.begin(), out.end());
    return out;
}

polygon::Region joined_region(const Loops& loops, std::uint32_t layer, Join join) {
    polygon::Region r;
    r.id = r.layer = layer;
    r.loops = loops;
    r.join = join;
    r.z = 0.2 * (layer + 1);
    r.height = 0.2;
    r.area = polygon::signed_area(loops);
    return r;
}

TEST(Scaffold, OfASquareIsTheMeanderOfKnownLength) {
    Notes notes;
    const Loops square = rectangle(0, 0, 20, 20);
    const auto curves = scaffold::scaffold(square, square, {}, notes);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_FALSE(curves[0].closed);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(curves[0].width, std::vector{0.4});
    // 20 strands, whose 19 turns are half circles of 0.5 mm
    const double expected = 20 * 19.6 + 19 * (std::numbers::pi / 2 - 1);
    EXPECT_LT(length_of(curves[0]), expected + 0.001);
    // chords that are off by s are shorter than an arc of radius r by s / 3r
    EXPECT_GT(length_of(curves[0]), expected - 19 * std::numbers::pi / 2 * polygon::kBeadArc / (3 * 0.5));
    const auto lines = strand_lines(curves[0], 0, 5);
    ASSERT_EQ(lines.size(), 20U);
    for (std::size_t i = 0; i < lines.size(); ++i) EXPECT_NEAR(lines[i], 0.5 + static_cast<double>(i), 1e-6);
}

TEST(Scaffold, StrandsOnTheVeryEdgeAreLaid) {
    Notes notes;
    const Loops square = rectangle(0, 0, 20, 20);
    const auto curves = scaffold::scaffold(square, square, {.spacing = 0.98}, notes);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(strand_lines(curves[0], 0, 5).size(), 21U);
}

// Every strand of the lattice is laid, nothing crosses, and each connected part is one stroke.
void expect_scaffold(const Loops& area, double angle, const std::string& name) {
    const double w = 0.4;
    Notes notes;
    const auto curves = scaffold::scaffold(area, area, {.angle = angle}, notes);
    expect_sound(curves);
    const Loops reach = polygon::rotated(inset(area, w / 2), -angle);
    EXPECT_EQ(curves.size(), polygon::split(reach).part.size()) << name << " at " << angle;
    EXPECT_EQ(crossings(curves), 0U) << name << " at " << angle;
    EXPECT_LT(farthest_outside(area, curves), 0.01) << name << " at " << angle;
    const auto box = polygon::bounds(polygon::rotated(area, -angle));
    const double middle = (box.lo.y + box.hi.y) / 2, span = std::floor(box.hi.y - box.lo.y - w + 1e-6);
    std::vector<double> y;
    for (double k = 0; k <= span; k += 1) y.push_back(middle - span / 2 + k);
    const auto rows = polygon::scan(reach, y);
    for (std::size_t i = 0; i < y.size(); ++i)
        for (const polygon::LevelStretch s : rows[i]) {
            std::vector<Vec2> p{{(s.from + s.to) / 2, y[i]}};
            polygon::rotate(p, angle);
            if (s.to - s.from > 2 * w) {
                EXPECT_LT(distance_to(curves, p[0]), 0.3) << name << " at " << angle;
            }
        }
}

TEST(Scaffold, LaysEveryStrandInOneStrokePerPart) {
    for (const auto& [name, area] : hard_regions())
        for (const double angle : {0.0, 1.0471975511965976, 1.5707963267948966}) expect_scaffold(area, angle, name);
}

TEST(Scaffold, LaysRandomRegions) {
    for (unsigned seed = 0; seed < 40; ++seed)
        for (const auto& area : random_regions(seed))
            if (polygon::signed_area(area) > 4) expect_scaffold(area, 0.1 * seed, std::to_string(seed));
}

// What is passed twice is laid in halves: the material is that of strands and boundary passed, each once.
TEST(Scaffold, LaysTheRightAmountWhereItPassesAgain) {
    Notes notes;
    const auto curves =
        scaffold::scaffold(yoke(), yoke(), {.angle = std::numbers::pi / 2, .from = Vec2{5.8, 19.5}}, notes);
    ASSERT_EQ(curves.size(), 1U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::path_runs_twice);
    double half = 0, all = 0;
    const Curve& c = curves[0];
    for (std::size_t i = 0; i + 1 < c.points.size(); ++i) {
        const double l = geom::distance(c.points[i], c.points[i + 1]);
        all += l;
        if (c.width_at(i) < 0.3 && c.width_at(i + 1) < 0.3) half += l;
    }
    EXPECT_NEAR(half, 2 * notes[0].amount, 0.15 * notes[0].amount); // less the tapers
    EXPECT_NEAR(laid(curves), 0.4 * (all - notes[0].amount), 0.02 * laid(curves));
}

TEST(Scaffold, AWalkPassesEachStrandOnce) {
    const Loops area = inset(yoke(), 0.2);
    std::vector<double> y;
    for (double v = 0.5; v < 20; v += 1) y.push_back(v);
    const StrandGraph graph = strand_graph(area, y, 0.4, Vec2{20, 20});
    ASSERT_EQ(graph.strands, 34U);
    ASSERT_TRUE(graph.start);
    EXPECT_NEAR(geom::distance(graph.node[*graph.start], {19.8, 19.8}), 0, 1e-3);
    double around = 0;
    for (const Arc& a : graph.arcs) around += a.length;
    EXPECT_NEAR(around, polygon::perimeter(area[0]), 1e-6);
    const StrandWalk walk = strand_walk(graph);
    EXPECT_EQ(walk.trails.size(), 1U);
    const Passes times = passes(graph, walk);
    for (const auto n : times.strand) EXPECT_EQ(n, 1U);
    // each step begins where the one before ended
    std::uint32_t at = *graph.start;
    for (const Step& s : walk.trails[0]) {
        const std::uint32_t a = s.strand ? 2 * s.id : graph.arcs[s.id].from;
        const std::uint32_t b = s.strand ? 2 * s.id + 1 : graph.arcs[s.id].to;
        ASSERT_EQ(s.against ? b : a, at);
        at = s.against ? a : b;
    }
}

// Monotone areas begun at a corner need no stretch twice.
TEST(Scaffold, ConvexAreasPassNothingAgain) {
    for (double height = 3; height < 12; height += 0.7)
        for (const double angle : {0.0, 0.4, 1.2}) {
            Notes notes;
            const Loops area = rectangle(0, 0, 9, height);
            EXPECT_EQ(scaffold::scaffold(area, area, {.angle = angle}, notes).size(), 1U);
            EXPECT_TRUE(notes.empty()) << height << " at " << angle;
        }
}

TEST(Scaffold, LayersOfAColumnBeginWhereTheOneBelowEnded) {
    Options o;
    o.pattern = Pattern::scaffold;
    for (const auto& angles : {std::vector<double>{0, 90}, std::vector<double>{0, 60, 120}, std::vector<double>{17}}) {
        o.angles_deg = angles;
        for (const auto& area : {rectangle(0, 0, 20, 20), disc({3, 4}, 5), yoke(),
                                 polygon::subtract(rectangle(0, 0, 15, 11), disc({7, 5}, 3))})
            for (const std::int64_t rings : {0, 2}) {
                ScaffoldState before;
                Notes notes;
                Vec2 end;
                o.rings = rings;
                for (std::uint32_t layer = 0; layer < 7; ++layer) {
                    const auto join = layer == 0 ? Join::start : Join::vertical;
                    const auto paths = fill_scaffold(joined_region(area, layer, join), o, before, notes);
                    ASSERT_EQ(paths.curves.size(), 1U);
                    const auto& c = paths.curves[0];
                    if (layer > 0) {
                        EXPECT_LT(geom::distance(c.points.front(), end), 0.01) << layer;
                    }
                    end = c.points.back();
                }
            }
    }
}

TEST(Scaffold, PoresRunThroughWhatTapers) {
    Options o;
    o.pattern = Pattern::scaffold;
    o.angles_deg = {0};
    o.spacing = 1;
    ScaffoldState before;
    Notes notes;
    for (std::uint32_t layer = 0; layer < 20; ++layer) {
        const double r = 10 - 0.13 * layer;
        const auto paths = fill_scaffold(
            joined_region(rectangle(-r, -r, r, r), layer, layer == 0 ? Join::start : Join::vertical), o, before, notes);
        for (const double y : strand_lines(paths.curves.at(0), 0, 5))
            EXPECT_NEAR(y - std::floor(y), 0.5, 0.004) << layer;
    }
}

TEST(Scaffold, EveryOtherRoundIsStaggered) {
    Options o;
    o.pattern = Pattern::scaffold;
    o.angles_deg = {0, 90};
    o.spacing = 1;
    o.stagger = 0.5;
    ScaffoldState before;
    Notes notes;
    for (std::uint32_t layer = 0; layer < 8; ++layer) {
        const auto paths = fill_scaffold(joined_region(rectangle(0, 0, 12, 12), layer, Join::start), o, before, notes);
        const auto lines = strand_lines(paths.curves.at(0), layer % 2 * std::numbers::pi / 2, 5);
        const double expected = layer / 2 % 2 == 0 ? 0.5 : 0;
        for (const double y : lines) EXPECT_NEAR(std::abs(std::remainder(y - expected, 1)), 0, 0.004) << layer;
    }
}

TEST(Scaffold, RingsBelongToTheStroke) {
    for (const auto& [name, area] : hard_regions())
        for (const int rings : {1, 2, 3}) {
            Notes notes, plain_notes;
            const auto curves = scaffold::scaffold(area, area, {.rings = rings}, notes);
            if (polygon::offset(area, -(rings + 1) * 0.4).empty()) continue;
            expect_sound(curves);
            EXPECT_LE(crossings(curves), 1U)
                << name << ", " << rings; // where a stretch passed again is left to the ring
            const auto parts = polygon::split(inset(area, (rings + 0.5) * 0.4)).part.size();
            EXPECT_EQ(curves.size(), parts) << name << ", " << rings;
            if (rings > 1) continue;
            const Loops rim = polygon::subtract(area, inset(area, 0.4)); // is dense
            EXPECT_GT(coverage(rim, curves, 0.05), 0.94) << name; // where two lanes share a wall, one is narrower
        }
}

TEST(Scaffold, SpacingBelowTheBeadWidthIsRefused) {
    Options o;
    o.pattern = Pattern::scaffold;
    o.bead_width = 0.5;
    o.spacing = 0.49;
    EXPECT_THROW(strand_spacing(o), Error);
    o.spacing = 0.5;
    EXPECT_EQ(strand_spacing(o), 0.5);
    o.spacing = 0;
    EXPECT_EQ(strand_spacing(o), 1.25);
}

TEST(Scaffold, WhatIsTooThinIsNoted) {
    Notes notes;
    const Loops area = regions_of(polygon::unite(rectangle(0, 0, 6, 6), rectangle(6, 3, 12, 3.3))).at(0);
    EXPECT_EQ(scaffold::scaffold(area, area, {}, notes).size(), 1U);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::area_unreached);
    EXPECT_NEAR(notes[0].amount, 1.8, 0.1);
}

TEST(Scaffold, IsTheSameEveryTime) {
    Notes a, b;
    for (const auto& area : random_regions(5))
        EXPECT_TRUE(
            same(scaffold::scaffold(area, area, {.rings = 1}, a), scaffold::scaffold(area, area, {.rings = 1}, b)));
}

} // namespace
} // namespace filum::fill
