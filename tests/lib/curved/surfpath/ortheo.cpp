// Lines upright on seed curves, where their number and their course are known.
#include "surfpath/ortheo.hpp"

#include "base/error.hpp"
#include "surface/curve/walk.hpp"
#include "surface/section.hpp"

#include "plans.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numbers>

namespace filum::surfpath {
namespace {

Surface grid(int nu, int nv, const std::function<Vec3(double, double)>& lift) {
    mesh::Mesh m;
    for (int j = 0; j <= nv; ++j)
        for (int i = 0; i <= nu; ++i)
            m.vertices.push_back(lift(static_cast<double>(i) / nu, static_cast<double>(j) / nv));
    const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (nu + 1) + i); };
    for (int j = 0; j < nv; ++j)
        for (int i = 0; i < nu; ++i)
            m.triangles.insert(m.triangles.end(), {{at(i, j), at(i + 1, j), at(i + 1, j + 1)},
                                                   {at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
    Notes notes;
    return surface::connect(m, notes);
}

surface::Sheet seeded(Surface s, const surface::Plane& plane) {
    surface::Sheet out{std::move(s), {}, {}, {}};
    out.sources.segments = surface::section(out.surface, plane);
    return out;
}

// Sector of a ring about the origin, radius 20 to 60, a right angle, its narrow rim the source.
surface::Sheet sector() {
    const int n = 60;
    surface::Sheet out{grid(n, 50,
                            [](double u, double v) {
                                const double a = std::numbers::pi / 2 * (1 - u), r = 20 + 40 * v;
                                return Vec3{r * std::cos(a), r * std::sin(a), 0};
                            }),
                       {},
                       {},
                       {}};
    for (std::uint32_t t = 0; t < out.surface.triangles.size(); ++t)
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const Vec3 &a = out.surface.vertices[out.surface.tail(h)], &b = out.surface.vertices[out.surface.head(h)];
            if (norm(a) < 20.001 && norm(b) < 20.001) out.sources.segments.push_back({t, a, b});
        }
    return out;
}

const Line& line(const Stroke& s) { return s.sections.at(0).line; }

TEST(Ortheo, OnARectangleLinesAreStraightAndGoThroughTheSeed) {
    const auto sheet = seeded(grid(20, 30,
                                   [](double u, double v) {
                                       return Vec3{20 * u, 30 * v, 0};
                                   }),
                              {{0, 1, 0}, 11});
    const Plan plan = ortheo(sheet, {.spacing = 1});
    ASSERT_EQ(plan.strokes.size(), 20U);
    EXPECT_EQ(fact(plan, "births"), 0);
    EXPECT_EQ(fact(plan, "cuts"), 19);
    for (std::size_t i = 0; i < 20; ++i) {
        const Line& l = line(plan.strokes[i]);
        EXPECT_NEAR(surface::curve::length(l), 30, 1e-6);
        for (const Place& p : l.places) EXPECT_NEAR(p.point.x, l[0].x, 1e-4);
    }
}

// The ring widens from 31.4 to 94.2 mm: at least 62 lines are born.  Lines lean only to make room, lie on the surface
// and cover it.
TEST(Ortheo, OnASectorLinesAreBornAsItWidens) {
    const auto sheet = sector();
    const Plan plan = ortheo(sheet, {.spacing = 1});
    const double net = fact(plan, "births") - fact(plan, "deaths");
    EXPECT_NEAR(net, 62, 5);
    EXPECT_GE(fact(plan, "births-lower-bound"), 54);
    EXPECT_LE(fact(plan, "births-lower-bound"), fact(plan, "births"));
    EXPECT_LE(fact(plan, "births"), 85);
    double length = 0, leaning = 0;
    for (const Stroke& s : plan.strokes) {
        const Line& l = line(s);
        for (std::size_t i = 0; i + 1 < l.size(); ++i) {
            const Vec3 way = l[i + 1] - l[i], out = 0.5 * (l[i] + l[i + 1]);
            if (norm(way) < 1e-9) continue;
            length += norm(way);
            if (std::abs(dot(way, out)) < std::cos(0.35) * norm(way) * norm(out)) leaning += norm(way);
        }
        for (const Place& p : l.places)
            EXPECT_LT(distance(surface::nearest_in(sheet.surface, p.triangle, p.point), p.point), 1e-9);
    }
    EXPECT_NEAR(length, std::numbers::pi / 4 * (3600 - 400), 0.04 * length);
    EXPECT_LT(leaning, 0.01 * length);
}

// A cylinder unrolls: nothing is born, and lines are helices of no slope.
TEST(Ortheo, OnACylinderNothingIsBorn) {
    const auto sheet = seeded(grid(30, 30,
                                   [](double u, double v) {
                                       const double a = 2 * u;
                                       return Vec3{15 * std::sin(a), 30 * v, 15 * std::cos(a)};
                                   }),
                              {{0, 1, 0}, 0.5});
    const Plan plan = ortheo(sheet, {.spacing = 1});
    EXPECT_EQ(fact(plan, "births"), 0);
    EXPECT_EQ(plan.strokes.size(), 30U);
    for (const Stroke& s : plan.strokes) EXPECT_NEAR(surface::curve::length(line(s)), 30, 1e-6);
}

TEST(Ortheo, WhatIsTooShortIsLeftOutWithANote) {
    const auto sheet = sector();
    const Plan all = ortheo(sheet, {.spacing = 1}), some = ortheo(sheet, {.spacing = 1, .min_length = 25});
    EXPECT_LT(some.strokes.size(), all.strokes.size());
    ASSERT_FALSE(some.notes.empty());
    EXPECT_EQ(some.notes[0].code, NoteCode::line_too_short);
    for (const Stroke& s : some.strokes) EXPECT_GT(surface::curve::length(line(s)), 24);
}

TEST(Ortheo, HairpinsLeadAllLinesIntoOne) {
    const auto sheet = seeded(grid(20, 30,
                                   [](double u, double v) {
                                       return Vec3{20 * u, 30 * v, 0};
                                   }),
                              {{0, 1, 0}, 11});
    const Plan plan = ortheo(sheet, {.spacing = 1, .turns = RowTurns::hairpin});
    ASSERT_EQ(plan.strokes.size(), 1U);
    EXPECT_EQ(fact(plan, "cuts"), 0);
}

TEST(Ortheo, NeedsSources) {
    const surface::Sheet sheet{grid(2, 2, [](double u, double v) { return Vec3{u, v, 0}; }), {}, {}, {}};
    EXPECT_THROW(ortheo(sheet, {}), Error);
}

} // namespace
} // namespace filum::surfpath
