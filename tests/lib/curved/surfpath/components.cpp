// Surfaces of several components.
#include "surfpath/components.hpp"

#include "base/error.hpp"
#include "geodesic/named_sources.hpp"
#include "surfpath/fexa.hpp"
#include "surfpath/outside.hpp"
#include "surfpath/plan/least_strokes.hpp"
#include "surfpath/plan/nearest_order.hpp"

#include "../../shapes/surface/grid.hpp"
#include "../../trials.hpp"
#include "plans.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::surfpath {
namespace {

// [0, a] x [0, b], its corner at `at`.
mesh::Mesh plate_at(double a, double b, const Vec3& at) {
    return surface::grid(a, b, static_cast<int>(a), static_cast<int>(b), [=](geom::Vec2 p) {
        return at + Vec3{p.x, p.y, 0};
    });
}

mesh::Mesh all_of(const std::vector<mesh::Mesh>& parts) {
    mesh::Mesh out;
    for (const mesh::Mesh& part : parts) {
        const auto first = static_cast<std::uint32_t>(out.vertices.size());
        out.vertices.insert(out.vertices.end(), part.vertices.begin(), part.vertices.end());
        for (const auto& t : part.triangles) out.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return out;
}

surface::Sheet sheet_from(const mesh::Mesh& mesh, const std::string& source) {
    Notes notes;
    surface::Sheet out{surface::connect(mesh, notes), {}, {}};
    if (!source.empty()) out.sources = geodesic::named_sources(out.surface, source, notes);
    return out;
}

std::vector<Vec3> points(const Stroke& stroke) {
    std::vector<Vec3> out;
    for (const Section& piece : stroke.sections)
        for (const Place& p : piece.line.places) out.push_back(p.point);
    return out;
}

// The strokes on a component.
std::vector<std::vector<Vec3>> strokes_on(const Surface& s, const Plan& plan, std::uint32_t component) {
    std::vector<std::vector<Vec3>> out;
    for (const Stroke& stroke : plan.strokes) {
        if (s.component[stroke.sections[0].line.places[0].triangle] != component) continue;
        out.push_back(points(stroke));
        for (const Section& piece : stroke.sections)
            for (const Place& p : piece.line.places)
                EXPECT_LT(distance(surface::nearest_in(s, p.triangle, p.point), p.point), 1e-6);
    }
    return out;
}

std::vector<std::vector<Vec3>> strokes_of(const Plan& plan) {
    std::vector<std::vector<Vec3>> out;
    for (const Stroke& stroke : plan.strokes) out.push_back(points(stroke));
    return out;
}

std::vector<std::vector<Vec3>> the_other_way_round(std::vector<std::vector<Vec3>> strokes) {
    std::reverse(strokes.begin(), strokes.end());
    for (auto& stroke : strokes) std::reverse(stroke.begin(), stroke.end());
    return strokes;
}

bool same(const std::vector<std::vector<Vec3>>& a, const std::vector<std::vector<Vec3>>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& s, const auto& t) {
        return std::equal(s.begin(), s.end(), t.begin(), t.end(),
                          [](const Vec3& p, const Vec3& q) { return distance(p, q) < 1e-6; });
    });
}

std::size_t noted(const Plan& plan, const std::string& what) {
    std::size_t out = 0;
    for (const Note& note : plan.notes) out += code_name(note).starts_with(what) ? note.count : 0;
    return out;
}

const mesh::Mesh kLower = plate_at(20, 14, {0, 0, 0}), kUpper = plate_at(19, 15, {0.7, 0.3, 0.2});

// The insets of two plates that almost touch lie beside each other: a row that looked for its end on both of them would
// find the other's.
TEST(Components, EachIsLaidAsIfItWereAlone) {
    for (const Algorithm a : {Algorithm::field, Algorithm::fexa, Algorithm::fina, Algorithm::ortheo, Algorithm::hybrid,
                              Algorithm::geo_fiso, Algorithm::geo_contour}) {
        if (kSanitized && a != Algorithm::field) continue;
        Options o{.algorithm = a, .least_radius = 1};
        o.follow.angle = a == Algorithm::field ? 1 : 0;
        o.follow.turn = 0.4;
        const std::string source = has_rows(a) && a != Algorithm::field ? "plane:1,0.3,0,9.7" : "";
        const auto both = sheet_from(all_of({kLower, kUpper}), source);
        const Plan laid = plan_paths(both, o);
        if (a == Algorithm::fexa) o.plane = plane_of(both.surface, both.sources);
        double rows = 0;
        for (const std::uint32_t c : {0U, 1U}) {
            const Plan alone = plan_paths(sheet_from(c == 0 ? kLower : kUpper, source), o);
            const auto found = strokes_on(both.surface, laid, c), asked = strokes_of(alone);
            ASSERT_FALSE(asked.empty()) << name(a);
            EXPECT_TRUE(same(found, asked) || same(found, the_other_way_round(asked))) << name(a) << ' ' << c;
            if (has_rows(a)) rows += fact(alone, "rows");
        }
        if (has_rows(a)) {
            EXPECT_EQ(fact(laid, "rows"), rows);
        }
        EXPECT_EQ(noted(laid, "component-cut"), 1U) << name(a);
    }
}

TEST(Components, BoundsAndCoverAreThoseOfTheWhole) {
    const auto both = sheet_from(all_of({kLower, plate_at(12, 12, {40, 0, 0})}), "");
    Options o{.algorithm = Algorithm::hybrid, .least_radius = 1};
    Plan laid = plan_paths(both, o);
    EXPECT_EQ(fact(laid, "cuts"), static_cast<double>(laid.strokes.size() - 1));
    finish(both.surface, laid, o);
    report_cuts_bound(both.surface, {o.spacing, o.cut_length, true}, laid);
    EXPECT_EQ(fact(laid, "cuts-bound"), 1);
    EXPECT_LT(fact(laid, "uncovered"), 0.1 * (20 * 14 + 12 * 12));
}

// The first has the least vertex, and each next one is the nearest, for any order in the file.
TEST(Components, AreLaidInTurn) {
    std::vector<mesh::Mesh> parts(6);
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i] = plate_at(6, 5, {10.0 * static_cast<double>(i), 0, 0});
    const Options o{.algorithm = Algorithm::geo_contour, .least_radius = 0.5};
    std::vector<std::vector<Vec3>> before;
    std::mt19937 random(5);
    for (int trial = 0; trial < 3; ++trial) {
        const auto sheet = sheet_from(all_of(parts), "");
        const Plan laid = plan_paths(sheet, o);
        ASSERT_EQ(laid.strokes.size(), parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            EXPECT_EQ(std::floor(points(laid.strokes[i])[0].x / 10), static_cast<double>(i));
        if (trial > 0) {
            EXPECT_EQ(strokes_of(laid), before);
        }
        before = strokes_of(laid);
        std::shuffle(parts.begin(), parts.end(), random);
    }
}

TEST(Components, WhatCannotBeLaidIsLeftOutAndTold) {
    const mesh::Mesh narrow = plate_at(20, 1, {0, 30, 0});
    const auto some = sheet_from(all_of({kLower, narrow}), "");
    const Plan laid = plan_paths(some, {.algorithm = Algorithm::geo_contour});
    EXPECT_EQ(laid.strokes.size(), 1U);
    EXPECT_EQ(noted(laid, "component-dropped"), 1U);
    for (const Note& note : laid.notes)
        if (note.code == NoteCode::component_dropped) {
            EXPECT_NEAR(note.amount, 20, 1e-9);
            EXPECT_EQ(note.y, 30);
        }
    const auto none = sheet_from(all_of({narrow, plate_at(15, 1, {0, 40, 0})}), "");
    EXPECT_THROW((void)plan_paths(none, {.algorithm = Algorithm::geo_contour}), Error);
}

TEST(Components, WithoutASourceAreLeftOutWhereOneIsNeeded) {
    const auto sheet = sheet_from(all_of({kLower, plate_at(20, 14, {0, 30, 0})}), "plane:0,1,0,7");
    const Plan laid = plan_paths(sheet, {.algorithm = Algorithm::fina, .least_radius = 1});
    EXPECT_EQ(laid.strokes.size(), 1U);
    EXPECT_EQ(noted(laid, "component-dropped"), 1U);
    EXPECT_EQ(noted(plan_paths(sheet, {.algorithm = Algorithm::fexa, .least_radius = 1}), "component-dropped"), 0U);
    const auto unseeded = sheet_from(all_of({kLower, kUpper}), "");
    EXPECT_THROW((void)plan_paths(unseeded, {.algorithm = Algorithm::fina}), Error);
    EXPECT_THROW((void)plan_paths(unseeded, {.algorithm = Algorithm::fexa}), Error);
}

// Against looking at all that is left.
TEST(InTurn, IsTheNearestNext) {
    std::mt19937 random(3);
    const auto place = [&] { return Vec3{1.0 * (random() % 9), 1.0 * (random() % 9), 1.0 * (random() % 9)}; };
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<EndPoints> ends(1 + random() % 30);
        for (EndPoints& e : ends) e = {place(), place()};
        const auto order = nearest_order(ends);
        ASSERT_EQ(order.size(), ends.size());
        EXPECT_EQ(order[0].row, 0U);
        EXPECT_FALSE(order[0].reversed);
        std::vector<char> done(ends.size(), 0);
        done[0] = 1;
        for (std::size_t k = 1; k < order.size(); ++k) {
            const EndPoints& last = ends[order[k - 1].row];
            const Vec3 at = order[k - 1].reversed ? last.begin : last.end;
            std::uint32_t best = 0;
            double least = 1e9;
            for (std::uint32_t e = 0; e < 2 * ends.size(); ++e) {
                const double far = norm2((e % 2 == 0 ? ends[e / 2].begin : ends[e / 2].end) - at);
                if (done[e / 2] == 0 && far < least) {
                    least = far;
                    best = e;
                }
            }
            EXPECT_EQ(order[k].row, best / 2);
            EXPECT_EQ(order[k].reversed, best % 2 == 1);
            done[order[k].row] = 1;
        }
    }
    EXPECT_TRUE(nearest_order({}).empty());
}

} // namespace
} // namespace filum::surfpath
