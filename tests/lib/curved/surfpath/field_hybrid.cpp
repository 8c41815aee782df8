// Paths along fields, where what must come of them is known.
#include "surfpath/field_hybrid.hpp"

#include "../../shapes/surface/grid.hpp"
#include "base/error.hpp"
#include "geom/angle.hpp"
#include "surface/curve/walk.hpp"
#include "surfpath/plan/cost.hpp"
#include "surfpath/rows/boustrophedon.hpp"
#include "surfpath/rows/rows.hpp"
#include "surfpath/rows/splice.hpp"

#include "../../trials.hpp"
#include "plans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace filum::surfpath {

using namespace rows;
namespace {

surface::Sheet sheet_of(const mesh::Mesh& mesh) {
    Notes notes;
    return {surface::connect(mesh, notes), {}, {}};
}

Options field(double turn) {
    Options out{.algorithm = Algorithm::field};
    out.follow.angle = 1;
    out.follow.turn = turn;
    return out;
}

mesh::Mesh plate() { return surface::flat_grid(30, 20, 40, 27); }

// Tube of radius 10 and 30 long.
mesh::Mesh tube() {
    mesh::Mesh out;
    const std::uint32_t n = 64, m = 30;
    for (std::uint32_t j = 0; j <= m; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n;
            out.vertices.push_back({10 * std::cos(a), 10 * std::sin(a), static_cast<double>(j)});
        }
    for (std::uint32_t j = 0; j < m; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = n * j + i, b = n * j + (i + 1) % n;
            out.triangles.insert(out.triangles.end(), {{a, b, b + n}, {a, b + n, a + n}});
        }
    return out;
}

TEST(Follow, APlateAtAnyAngleIsOnePathOfStraightRows) {
    for (const double degrees : kSanitized ? std::vector{30.0} : std::vector{0.0, 30.0, 45.0, 90.0}) {
        const auto sheet = sheet_of(plate());
        Options o = field(degrees * geom::kDegree);
        o.least_radius = 0.5; // turns are small beside the plate
        const Plan p = plan_paths(sheet, o);
        EXPECT_EQ(p.strokes.size(), 1U) << degrees;
        EXPECT_GT(covered(sheet.surface, p), 0.9) << degrees;
        EXPECT_LT(fact(p, "tightest-bend"), 1e-3) << degrees;
    }
}

// On needlessly fine triangles lines are planned on larger ones, cover as much, and lie on those given.
TEST(Follow, FineTrianglesDoNotCount) {
    const auto bent = [](geom::Vec2 p) { return Vec3{p.x, p.y, 2 * std::sin(p.x / 8) * std::cos(p.y / 10)}; };
    const auto fine = sheet_of(surface::grid(16, 16, 80, 80, bent));
    Options o = field(0);
    o.keep = Priority::spacing; // needs triangles of one spacing
    const Plan coarsened = plan_paths(fine, o);
    o.coarsen = false;
    const Plan exact = plan_paths(fine, o);
    EXPECT_NEAR(covered(fine.surface, coarsened), covered(fine.surface, exact), 0.03);
    for (const Stroke& stroke : coarsened.strokes)
        for (const Section& section : stroke.sections)
            for (const Place& p : section.line.places)
                EXPECT_LT(distance(surface::nearest_in(fine.surface, p.triangle, p.point), p.point), 1e-6);
}

// Pieces of fibre that are too short for the machine are left out, and a note counts them.
TEST(Follow, ShortPiecesOfFibreAreLeftOut) {
    const auto sheet = sheet_of(plate());
    Options o = field(45 * geom::kDegree);
    o.turns = RowTurns::none; // every line is a piece; they are short in two corners
    Plan all = plan_paths(sheet, o);
    const auto length = [](const Stroke& stroke) {
        double out = 0;
        for (const Section& section : stroke.sections) out += surface::curve::length(section.line);
        return out;
    };
    const auto shorter = [&](const Stroke& stroke) { return length(stroke) < 10; };
    const auto few = static_cast<std::size_t>(std::count_if(all.strokes.begin(), all.strokes.end(), shorter));
    ASSERT_GT(few, 0U);
    Plan some = all;
    leave_out_short(some, 10);
    EXPECT_EQ(some.strokes.size() + few, all.strokes.size());
    EXPECT_EQ(fact(some, "cuts"), static_cast<double>(some.strokes.size()) - 1);
    ASSERT_FALSE(some.notes.empty());
    EXPECT_EQ(some.notes.back().count, few);
    EXPECT_TRUE(std::none_of(some.strokes.begin(), some.strokes.end(), shorter));
}

// Where there is no room for wide turns, lines turn at the strip's ends, not before.
TEST(Follow, ANarrowStripIsCoveredToItsEnds) {
    for (const double width : {3.0, 5.0}) {
        const auto sheet = sheet_of(surface::grid(50, width, 50, static_cast<int>(width), [](geom::Vec2 p) {
            return Vec3{p.x, p.y, 0};
        }));
        const Plan p = plan_paths(sheet, field(0));
        EXPECT_EQ(p.strokes.size(), 1U) << width;
        EXPECT_GT(covered(sheet.surface, p), 0.95) << width; // of the narrower one .957 by areas, at either end
    }
}

// Where there is no room for the margin on either side, a line lies in the middle; narrower than two such there are
// two.
TEST(Follow, AStripAsWideAsALineOrLessIsOneLine) {
    for (const double width : {0.6, 0.8, 1.0, 1.8}) {
        const auto sheet = sheet_of(surface::flat_grid(60, width, 60, 1));
        const Plan p = plan_paths(sheet, field(0));
        ASSERT_EQ(p.strokes.size(), 1U) << width;
        double length = 0;
        for (const Section& piece : p.strokes[0].sections) length += surface::curve::length(piece.line);
        EXPECT_GT(covered(sheet.surface, p), width > 1 ? 0.89 : 0.97) << width; // there is no room to turn
        EXPECT_GT(length, width > 1 ? 105 : 58) << width;
        EXPECT_LT(length, width > 1 ? 120 : 60) << width;
    }
}

TEST(Follow, LinesAloneCoverAllAndNothingTwice) {
    const auto sheet = sheet_of(plate());
    Options o = field(25 * geom::kDegree);
    o.turns = RowTurns::none;
    const Plan p = plan_paths(sheet, o);
    double length = 0;
    for (const Stroke& s : p.strokes) length += surface::curve::length(s.sections.at(0).line);
    EXPECT_NEAR(length, 600, 12);
    EXPECT_GT(covered(sheet.surface, p), 0.985);
}

// Where directions are no numbers, lines go on as they come, and a note reports it.
TEST(Follow, DirectionsThatAreNoNumbersAreTold) {
    auto sheet = sheet_of(plate());
    surface::Field given{kDirection, {}, 3};
    for (const Vec3& p : sheet.surface.vertices) {
        const bool lost = p.x > 12 && p.x < 18 && p.y < 10;
        const double none =
            p.x < 15 ? std::numeric_limits<double>::quiet_NaN() : std::numeric_limits<double>::infinity();
        const Vec3 d = lost ? Vec3{none, 1, 0} : Vec3{1, 0, 0};
        given.values.insert(given.values.end(), {d.x, d.y, d.z});
    }
    const Plan whole = plan_paths(sheet, {.algorithm = Algorithm::field, .turns = RowTurns::none});
    EXPECT_TRUE(whole.notes.empty());
    sheet.fields = {given};
    const Plan p = plan_paths(sheet, {.algorithm = Algorithm::field, .turns = RowTurns::none});
    const auto told = std::find_if(p.notes.begin(), p.notes.end(),
                                   [](const Note& n) { return n.code == NoteCode::direction_unknown; });
    ASSERT_NE(told, p.notes.end());
    EXPECT_GT(told->amount, 50);
    EXPECT_LT(told->amount, 90);
    EXPECT_GT(told->x, 10);
    EXPECT_LT(told->x, 20);
    ASSERT_EQ(p.strokes.size(), whole.strokes.size());
    for (const Stroke& stroke : p.strokes)
        for (const Vec3& at : points(stroke)) EXPECT_NEAR(at.y, points(stroke)[0].y, 0.02);
    for (double& value : sheet.fields[0].values) value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(plan_paths(sheet, {.algorithm = Algorithm::field}), Error);
}

// Without --turns the path is the cheaper one of that with wide turns and that with hairpins.
TEST(Follow, UsualTurnsAreThoseThatCostLess) {
    std::mt19937 random(3);
    const auto between = [&](double lo, double hi) { return std::uniform_real_distribution(lo, hi)(random); };
    bool hairpins = false, wide = false;
    for (int i = 0; i < trials(12); ++i) {
        const auto sheet = sheet_of(surface::flat_grid(between(12, 30), between(12, 30), 24, 24));
        Options o = field(between(0, std::numbers::pi));
        o.least_radius = i % 3 == 0 ? 0.55 : between(0.6, 3);
        const auto cost = [&](RowTurns turns) {
            o.turns = turns;
            return plan::cost(sheet.surface, plan_paths(sheet, o), {o.spacing, o.least_radius, o.cut_length, 0});
        };
        const double usual = cost(RowTurns::usual), tight = cost(RowTurns::hairpin), gentle = cost(RowTurns::wide);
        EXPECT_NEAR(usual, std::min(tight, gentle), 0.02 * usual) << i; // planned on other triangles
        hairpins = hairpins || usual < gentle;
        wide = wide || usual < tight;
        o.strict = true;
        EXPECT_DOUBLE_EQ(cost(RowTurns::usual), gentle) << i;
    }
    EXPECT_TRUE(hairpins || kSanitized); // with few trials only one of them may occur
    EXPECT_TRUE(wide || kSanitized);
}

// Round the tube lines are closed: they become one helix from rim to rim.
TEST(Follow, RoundATubeIsOneHelix) {
    const auto sheet = sheet_of(tube());
    Options o = field(90 * geom::kDegree);
    o.follow.reference = {0, 0, 1};
    const Plan p = plan_paths(sheet, o);
    ASSERT_EQ(p.strokes.size(), 1U);
    EXPECT_GT(covered(sheet.surface, p), 0.97);
    double length = 0;
    for (const Section& piece : p.strokes[0].sections) length += surface::curve::length(piece.line);
    EXPECT_NEAR(length, 30 * 2 * std::numbers::pi * 10, 80);
}

// Places decide, not numbers.
TEST(Follow, TheOrderOfTrianglesDoesNotMatter) {
    FILUM_NOT_SANITIZED();
    auto mesh = plate();
    const Plan one = plan_paths(sheet_of(mesh), field(0.5));
    std::rotate(mesh.triangles.begin(), mesh.triangles.begin() + 1000, mesh.triangles.end());
    const Plan other = plan_paths(sheet_of(mesh), field(0.5));
    ASSERT_EQ(one.strokes.size(), other.strokes.size());
    ASSERT_EQ(one.strokes[0].sections.size(), other.strokes[0].sections.size());
    for (std::size_t i = 0; i < one.strokes[0].sections.size(); ++i)
        EXPECT_EQ(one.strokes[0].sections[i].line[0], other.strokes[0].sections[i].line[0]);
}

// Between a hole of radius 4 and a circle of radius 14; the hole lies `aside` mm off the middle.
mesh::Mesh washer(double aside) {
    mesh::Mesh out;
    const std::uint32_t n = 96, m = 14;
    for (std::uint32_t j = 0; j <= m; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n, t = static_cast<double>(j) / m, r = 4 + 10 * t;
            out.vertices.push_back({r * std::cos(a) - (1 - t) * aside, r * std::sin(a), 0});
        }
    for (std::uint32_t j = 0; j < m; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = n * j + i, b = n * j + (i + 1) % n;
            out.triangles.insert(out.triangles.end(), {{a, a + n, b + n}, {a, b + n, b}});
        }
    return out;
}

TEST(Hybrid, RingsAloneAreOneSpiralThatGoesOverAtASeam) {
    const auto sheet = sheet_of(washer(0));
    const Plan p = plan_paths(sheet, {.algorithm = Algorithm::hybrid});
    ASSERT_EQ(p.strokes.size(), 1U);
    EXPECT_GT(covered(sheet.surface, p), 0.985);
    double length = 0;
    for (const Section& piece : p.strokes[0].sections) length += surface::curve::length(piece.line);
    EXPECT_NEAR(length, std::numbers::pi * (14 * 14 - 4 * 4), 25);
}

// No seam leads over all rings of a small disc, as the innermost are too short: they are joined, one by one, rather
// than wound from a first ring that is half uncovered.
TEST(Hybrid, RingsOfASmallDiscAreJoined) {
    const auto sheet = sheet_of(surface::grid(2, 2, 40, 40, [](geom::Vec2 p) {
        const double x = p.x - 1, y = p.y - 1; // a square made a disc
        return Vec3{9.7 * x * std::sqrt(1 - y * y / 2), 9.7 * y * std::sqrt(1 - x * x / 2), 0};
    }));
    const Plan p = plan_paths(sheet, {.algorithm = Algorithm::hybrid});
    EXPECT_EQ(p.strokes.size(), 1U);
    EXPECT_GT(covered(sheet.surface, p), 0.97);
}

// A line that cuts off a corner, as far from the other rows as from the others along the rim: the way there would lay
// twenty times as much twice as it covers.
TEST(Rows, ThatAreNotWorthTheirWayAreLeftOut) {
    const auto sheet = sheet_of(surface::flat_grid(40, 40, 40, 40));
    const Surface& s = sheet.surface;
    std::vector<UnclippedLine> lines;
    const auto add = [&](const Vec3& from, const Vec3& to) {
        Line line;
        for (const Vec3& p : {from, to}) {
            const auto at = surface::nearest(s, p);
            line.places.push_back({at.triangle, at.a});
        }
        lines.push_back({surface::curve::threaded(s, line), static_cast<double>(lines.size())});
    };
    for (int i = 0; i < 8; ++i) add({0, i + 0.5, 0}, {40, i + 0.5, 0});
    add({0, 38, 0}, {2, 40, 0});
    const Rows found = rows::rows(s, lines, {0.5, 0.5, 0.5, 0.1});
    ASSERT_EQ(found.rows.size(), 9U);
    TurnOptions turns = turn_options(1, 2.4);
    turns.tight = true;
    const Plan p = boustrophedon(s, found, turns);
    EXPECT_EQ(p.strokes.size(), 1U);
    EXPECT_LT(fact(p, "transits"), 5);
    const auto told = [](const Note& n) { return n.code == NoteCode::rows_not_worth; };
    EXPECT_EQ(std::count_if(p.notes.begin(), p.notes.end(), told), 1);
}

// Where rings about the hole meet those along the rim, lines turn; all is one stroke.
TEST(Hybrid, RingsThatMeetAreOneStroke) {
    for (const double aside : kSanitized ? std::vector{4.0} : std::vector{3.0, 4.0, 6.0}) {
        const auto sheet = sheet_of(washer(aside));
        const Plan p = plan_paths(sheet, {.algorithm = Algorithm::hybrid});
        EXPECT_EQ(p.strokes.size(), 1U) << aside;
        EXPECT_GT(covered(sheet.surface, p), 0.95) << aside;
    }
}

// 100 degrees of a cone of 20 degrees: lines about its middle hang together as a chain that comes round. It was led to
// the others by a way along the rim, 32 mm of it twice.
TEST(Hybrid, AChainThatComesRoundIsNoWayAlongTheRim) {
    FILUM_NOT_SANITIZED();
    const auto sheet = sheet_of(surface::grid(1, 1, 60, 60, [](geom::Vec2 p) {
        const double slope = 20 * geom::kDegree, a = 100 * geom::kDegree * p.x;
        const double r = 15 + 40 * std::sin(slope) * p.y;
        return Vec3{r * std::cos(a), r * std::sin(a), 40 * std::cos(slope) * p.y};
    }));
    const Plan p = plan_paths(sheet, {.algorithm = Algorithm::hybrid});
    EXPECT_EQ(p.strokes.size(), 1U);
    EXPECT_LT(fact(p, "transits"), 2 * 2.4);
}

TEST(Rows, ALoopBesideAHoleStaysClosed) {
    const auto sheet = sheet_of(washer(0));
    const Surface& s = sheet.surface;
    for (const double off : {0.0, 0.05, 0.1, 1.0}) { // the middle of the loop from that of the hole, mm
        Line loop;
        loop.closed = true;
        for (int i = 0; i < 400; ++i) {
            const double a = 2 * std::numbers::pi * i / 400;
            const auto at = surface::nearest(s, Vec3{4.3 * std::cos(a) + off, (4.3 + off) * std::sin(a), 0});
            loop.places.push_back({at.triangle, at.a});
        }
        const Rows found =
            rows::rows(s, std::vector{UnclippedLine{surface::curve::threaded(s, loop), 0}}, {0.5, 0.5, 2.4, 0.1});
        if (off > 0.5) { // it leaves the surface: no ring leads past that
            for (const Row& row : found.rows) EXPECT_FALSE(row.line.closed);
            continue;
        }
        ASSERT_EQ(found.rows.size(), 1U) << off;
        const Line& line = found.rows[0].line;
        EXPECT_TRUE(line.closed) << off;
        EXPECT_NEAR(surface::curve::length(line), 2 * std::numbers::pi * 4.5, 0.5) << off;
        for (std::size_t i = 0; i < line.size(); ++i) EXPECT_GT(std::hypot(line[i].x, line[i].y), 4.35) << off;
    }
}

// A loop beside a straight line becomes part of it, and nothing of it is lost but what the shifts save.
TEST(Splice, ALoopBecomesPartOfTheLineBesideIt) {
    const auto sheet = sheet_of(plate());
    const Surface& s = sheet.surface;
    const auto place = [&](double x, double y) {
        const auto at = surface::nearest(s, {x, y, 0});
        return Place{at.triangle, at.a};
    };
    Line straight, loop;
    for (int i = 0; i <= 280; ++i) straight.places.push_back(place(1 + 0.1 * i, 5));
    for (int i = 0; i <= 200; ++i) loop.places.push_back(place(5 + 0.1 * i, 6));
    for (int i = 0; i <= 30; ++i) loop.places.push_back(place(25, 6.1 + 0.1 * i));
    for (int i = 0; i <= 200; ++i) loop.places.push_back(place(25 - 0.1 * i, 9.1));
    for (int i = 1; i < 30; ++i) loop.places.push_back(place(5, 9.1 - 0.1 * i));
    loop.closed = true;
    std::vector<Line> lines{surface::curve::threaded(s, straight), surface::curve::threaded(s, loop)};
    const double before = surface::curve::length(lines[0]) + surface::curve::length(lines[1]);
    const auto crossed = splice_loops(s, lines, {0, 0}, 1, 2.4);
    EXPECT_EQ(lines[1].size(), 0U); // taken in
    EXPECT_EQ(crossed.size(), 1U);
    EXPECT_FALSE(lines[0].closed);
    EXPECT_NEAR(surface::curve::length(lines[0]), before, 2);
    EXPECT_NEAR(lines[0][0].x, 1, 1e-9);
    EXPECT_NEAR(lines[0][lines[0].size() - 1].x, 29, 1e-9);
    // The loop's own corners apart, nothing turns within less than the radius, by circles through points 0.25 mm apart.
    const auto ways = surface::curve::arc_lengths(lines[0]);
    std::size_t shifted = 0;
    for (double way = 0.25; way + 0.25 < ways.back(); way += 0.05) {
        const Vec3 p = surface::curve::at(lines[0], ways, way).point;
        if (p.y > 6.2 || p.x < 6 || p.x > 24) continue;
        const Vec3 a = surface::curve::at(lines[0], ways, way - 0.25).point,
                   b = surface::curve::at(lines[0], ways, way + 0.25).point;
        EXPECT_LT(2 * norm(cross(p - a, b - p)) / (distance(a, p) * distance(p, b) * distance(a, b)), 1 / 2.4);
        shifted += p.y > 5.1 && p.y < 5.9 ? 1 : 0;
    }
    EXPECT_GT(shifted, 20U);
}

} // namespace
} // namespace filum::surfpath
