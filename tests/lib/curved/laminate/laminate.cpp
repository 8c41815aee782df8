#include "laminate/laminate.hpp"

#include "../../shapes/surface/grid.hpp"
#include "metrics/surface/map_sheet.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace filum::laminate {
namespace {

using geom::Vec2;

const Ply kWide{.spacing = 2}; // fewer lines, less to do

Options narrow() { // turns, so that lines are more than turns
    Options out;
    out.least_radius = 1;
    return out;
}

surface::Sheet sheet(const std::function<Vec3(Vec2)>& lift) {
    Notes notes;
    return {surface::connect(surface::grid(20, 24, 20, 24, lift), notes), {}, {}};
}

surface::Sheet flat() {
    return sheet([](Vec2 p) { return Vec3{p.x, p.y, 0}; });
}

double fact(const Laminate& l, const std::string& name) {
    for (const Fact& f : l.facts)
        if (f.name == name) return f.value;
    ADD_FAILURE() << name;
    return -1;
}

TEST(Laminate, IsAsThickAsItsBeadsAreMuch) {
    const auto plies = plies_of("0,90", Ply{.spacing = 2, .height = 0.25}, false);
    const auto made = laminate(flat(), plies, narrow(), 1);
    double volume = 0, area = 0;
    for (const PlacedPly& l : made.plies)
        for (const auto& stroke : l.plan.strokes)
            for (const auto& piece : stroke.sections) volume += surface::curve::length(piece.line) * 2 * 0.25;
    for (const double a : made.map.area) area += a;
    EXPECT_NEAR(area, 480, 1e-6);
    // What hangs over the rim, and passes of a bead that are one by being near along it, are not in the map.
    EXPECT_NEAR(fact(made, "thickness-mean"), volume / area, 0.02 * volume / area);
    EXPECT_EQ(fact(made, "thickness-nominal"), 0.5);
    EXPECT_GE(fact(made, "thickness-most"), fact(made, "even-most"));
    EXPECT_LE(fact(made, "thickness-least"), fact(made, "even-least"));
    for (std::size_t v = 0; v < made.map.thickness.size(); ++v)
        EXPECT_EQ(made.map.thickness[v], 0.25 * (made.map.plies[0].passes[v] + made.map.plies[1].passes[v]));
}

TEST(Laminate, LinesRunAtTheirAnglesOnBothSides) {
    auto plies = plies_of("30,30", kWide, false);
    plies[1].under = true;
    const auto made = laminate(flat(), plies, narrow(), 1);
    for (const std::size_t k : {0U, 1U}) {
        double along = 0, all = 0; // by hand: the part of the length along 30 degrees from x, seen from above
        for (const auto& stroke : made.plies[k].plan.strokes)
            for (const auto& piece : stroke.sections)
                for (std::size_t i = 1; i < piece.line.size(); ++i) {
                    const Vec3 way = piece.line[i] - piece.line[i - 1];
                    const double c = std::abs(way.x * std::sqrt(0.75) + way.y * 0.5) / std::max(norm(way), 1e-12);
                    all += norm(way);
                    along += c > 0.99 ? norm(way) : 0;
                }
        EXPECT_GT(along, 0.6 * all) << k;
        EXPECT_LT(fact(made, "ply." + std::to_string(k + 1) + ".angle-median"), 0.5);
    }
}

TEST(Laminate, PliesLieOnEachOther) {
    const auto tube = sheet([](Vec2 p) { return Vec3{12 * std::cos(p.x / 12), 12 * std::sin(p.x / 12), p.y}; });
    const auto plies = plies_of("0,90", Ply{.spacing = 2, .height = 0.4}, false);
    Options o = narrow();
    o.reference = {0, 0, 1};
    const auto made = laminate(tube, plies, o, 2);
    std::vector<toolpath::Span> spans;
    add_spans(made, plies, o, 0, spans);
    for (const auto& span : spans) {
        if (!toolpath::extrudes(span.role)) continue;
        for (const Vec3& p : span.points) EXPECT_NEAR(std::hypot(p.x, p.y), 12 + 0.4 * span.layer, 0.02) << span.layer;
    }
    EXPECT_EQ(spans.back().layer, 1U);
    EXPECT_EQ(fact(made, "unsymmetric"), 2);
    const auto map = metrics::surface::sheet_of(made.map, "tube");
    EXPECT_EQ(map.fields.size(), 4 + 5 * plies.size());
}

TEST(Laminate, TurnsOutsideLeavePliesEven) {
    const auto plies = plies_of("0,90", kWide, false);
    Options o = narrow(), inside = narrow();
    o.turn_outside = 5;
    inside.turns = surfpath::RowTurns::wide;
    const auto made = laminate(flat(), plies, o, 2), on_it = laminate(flat(), plies, inside, 2);
    for (const std::string ply : {"ply.1.", "ply.2."}) {
        EXPECT_LT(fact(made, ply + "bare"), 0.02);
        EXPECT_LT(fact(made, ply + "twice"), 0.02);
        EXPECT_GT(fact(made, ply + "trims"), 10);
        EXPECT_GT(fact(made, ply + "outside"), 10);
    }
    EXPECT_GT(fact(made, "thickness-low"), fact(on_it, "thickness-low"));
    EXPECT_LT(fact(made, "thickness-high"), fact(on_it, "thickness-high"));
}

TEST(Laminate, PliesThatGoStraightAcrossAHoleAreEvenAboutIt) {
    Notes notes;
    const auto level = [](Vec2 p) { return Vec3{p.x, p.y, 0}; };
    const auto hole = [](Vec2 p) { return std::hypot(p.x - 15, p.y - 15) < 4; };
    const surface::Sheet pierced{surface::connect(surface::pierced_grid(30, 30, 30, 30, level, hole), notes), {}, {}};
    Options o = narrow();
    o.turn_outside = 5;
    const auto made = laminate(pierced, plies_of("0,60", kWide, false), o, 2);
    EXPECT_GT(fact(made, "even-least"), 0.9 * 0.4);
    EXPECT_LT(fact(made, "even-most"), 1.1 * 0.4);
    const auto told = std::count_if(made.notes.begin(), made.notes.end(),
                                    [](const Note& n) { return n.code == NoteCode::hole_covered; });
    EXPECT_EQ(told, 2); // of each ply
}

// How near a birth of the second ply comes to one of the first, mm.
double births_apart(const Laminate& l) {
    double out = 1e9;
    for (const Vec3& p : l.plies[1].plan.births)
        for (const Vec3& q : l.plies[0].plan.births) out = std::min(out, distance(p, q));
    return out;
}

// On a fan, where lines must be born.
TEST(Laminate, LinesOfPliesThatRunAlikeAreBornApart) {
    const auto fan = sheet([](Vec2 p) {
        const double a = 1.2 * p.x / 20, r = 8 + p.y;
        return Vec3{r * std::cos(a), r * std::sin(a), 0.1 * p.y};
    });
    const auto plies = plies_of("0,0", Ply{}, false);
    Options apart = narrow(), alike = narrow();
    apart.reference = alike.reference = {0, 0, 1};
    alike.stagger = false;
    const auto first = laminate(fan, plies, apart, 2), second = laminate(fan, plies, alike, 2);
    ASSERT_GE(first.plies[0].plan.births.size(), 3U);
    EXPECT_GT(births_apart(first), 1);
    EXPECT_LT(births_apart(second), 0.5);
}

// How far from each other the paths of two plies begin.
double begins_apart(const Laminate& l) {
    const auto at = [&](std::size_t k) { return l.plies[k].plan.strokes.front().sections.front().line[0]; };
    return distance(at(0), at(1));
}

TEST(Laminate, EverySecondPlyOfADirectionBeginsAtTheOtherEnd) {
    const auto plies = plies_of("30,30", kWide, false);
    Options apart = narrow(), alike = narrow();
    alike.stagger = false;
    EXPECT_GT(begins_apart(laminate(flat(), plies, apart, 2)), 10);
    EXPECT_LT(begins_apart(laminate(flat(), plies, alike, 2)), 1);
}

TEST(Laminate, PliesThatEndAtARimAndWithinTurnOutsideAtTheRimOnly) {
    auto plies = plies_of("0", kWide, false);
    plies[0].within = "half";
    Options o = narrow();
    o.turn_outside = 5;
    o.areas["half"].curves = {{{0, 0, 0}, {12, 0, 0}, {12, 20, 0}, {0, 20, 0}}};
    const auto made = laminate(flat(), plies, o, 1);
    double left = 0, right = 0;
    for (const auto& stroke : made.plies[0].plan.strokes)
        for (const auto& piece : stroke.sections)
            for (const auto& p : piece.line.places) {
                left = std::min(left, p.point.x);
                right = std::max(right, p.point.x);
            }
    EXPECT_LT(left, -2);
    EXPECT_NEAR(right, 11, 0.5);
    EXPECT_GE(fact(made, "ply.1.trims"), 10);
}

TEST(Laminate, PliesEndWhereTheyShouldAndThoseAboveStepDown) {
    auto plies = plies_of("0,0,90", Ply{.spacing = 1, .height = 0.25}, false);
    plies[0].within = plies[1].within = "half";
    Options o = narrow();
    o.areas["half"].curves = {{{-0.5, 0.1, 0}, {12, 0.1, 0}, {12, 19.9, 0}, {-0.5, 19.9, 0}}};
    o.ramp = 8;
    const auto made = laminate(flat(), plies, o, 2);
    std::vector<toolpath::Span> spans;
    add_spans(made, plies, o, 0, spans);
    const double ends[] = {12, 10, 20};
    for (const auto& span : spans) {
        if (!toolpath::extrudes(span.role)) continue;
        for (const Vec3& p : span.points) {
            EXPECT_LT(p.x, ends[span.layer] - 0.3) << span.layer;
            if (span.layer < 2) continue; // on the ramp of two plies, from x = 10 down to x = 14
            const double below = 0.25 * (std::clamp((12 - p.x) / 2, 0.0, 1.0) + std::clamp((14 - p.x) / 2, 0.0, 1.0));
            if (p.y > 2.5 && p.y < 17.5 && p.x > 2.5) {
                EXPECT_NEAR(p.z, below, 0.03) << p.x;
            }
        }
    }
    EXPECT_LT(fact(made, "ply.2.area"), fact(made, "ply.1.area"));
    EXPECT_LT(fact(made, "ply.2.bare"), 0.1);
}

TEST(Laminate, IsTheSameForAnyNumberOfThreads) {
    const auto plies = plies_of("0,45", kWide, false);
    const auto a = laminate(flat(), plies, narrow(), 1), b = laminate(flat(), plies, narrow(), 8);
    EXPECT_EQ(a.map.thickness, b.map.thickness);
    EXPECT_EQ(a.map.even, b.map.even);
}

TEST(Laminate, TellsAStackThatWarps) {
    const auto made = laminate(flat(), plies_of("0,45", kWide, false), narrow(), 1);
    std::size_t told = 0;
    for (const Note& n : made.notes) told += code_name(n).starts_with("stack-un") ? 1 : 0;
    EXPECT_EQ(told, 2U);
}

} // namespace
} // namespace filum::laminate
