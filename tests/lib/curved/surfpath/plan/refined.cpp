// The sheet that lines are found on is the given one, in triangles of its own.
#include "surfpath/plan/refined.hpp"

#include "../../../shapes/surface/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace filum::surfpath {

using namespace plan;
namespace {

Vec3 bent(geom::Vec2 p) { return {p.x, p.y, 0.02 * p.x * p.x}; }

surface::Sheet coarse() {
    Notes notes;
    surface::Sheet out;
    out.surface = surface::connect(surface::grid(30, 20, 3, 2, bent), notes);
    return out;
}

double length(const surface::Sources& sources) {
    double out = 0;
    for (const auto& g : sources.segments) out += distance(g.a, g.b);
    return out;
}

TEST(RefinedSheet, HasShortSidesOnTheSameTriangles) {
    const auto sheet = coarse();
    const RefinedSheet f = refined(sheet, 2);
    const Surface& s = f.sheet.surface;
    EXPECT_NEAR(surface::area(s), surface::area(sheet.surface), 1e-9);
    EXPECT_EQ(s.rims.size(), 1U);
    ASSERT_EQ(f.parent.size(), s.triangles.size());
    for (std::uint32_t h = 0; h < s.twin.size(); ++h) {
        EXPECT_LE(surface::side_length(s, h), 2);
        const Vec3& p = s.vertices[s.tail(h)];
        EXPECT_LT(distance(surface::nearest_in(sheet.surface, f.parent[h / 3], p), p), 1e-9);
    }
}

// Sources run on over all the triangles that theirs fell into, each stretch once, even just between two of them.
TEST(RefinedSheet, SourcesStayWholeAndSingle) {
    std::mt19937 random(4);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    auto sheet = coarse();
    const Surface& s = sheet.surface;
    for (int round = 0; round < 60; ++round) {
        sheet.sources = {};
        const auto t = static_cast<std::uint32_t>(random() % s.triangles.size());
        const Vec3 &a = s.vertices[s.triangles[t][0]], ab = s.vertices[s.triangles[t][1]] - a,
                   ac = s.vertices[s.triangles[t][2]] - a;
        const auto inside = [&](double u, double v) { return a + u * ab + v * ac; };
        const double u = unit(), v = unit() * (1 - u), x = unit(), y = unit() * (1 - x);
        if (round % 3 == 0) // between the middles of two sides, where triangles are cut
            sheet.sources.segments = {{t, inside(0.5, 0), inside(0, 0.5)}};
        else if (round % 3 == 1) // along a side
            sheet.sources.segments = {{t, a, inside(1, 0)}};
        else
            sheet.sources.segments = {{t, inside(u, v), inside(x, y)}};
        const RefinedSheet f = refined(sheet, 1.5);
        const auto& now = f.sheet.sources;
        EXPECT_NEAR(length(now), length(sheet.sources), 1e-9) << round;
        const auto& whole = sheet.sources.segments[0];
        EXPECT_EQ(now.segments.front().a, whole.a);
        EXPECT_EQ(now.segments.back().b, whole.b);
        for (std::size_t i = 0; i < now.segments.size(); ++i) {
            const auto& g = now.segments[i];
            EXPECT_EQ(f.parent[g.triangle], t);
            for (const Vec3& p : {g.a, g.b})
                EXPECT_LT(distance(surface::nearest_in(f.sheet.surface, g.triangle, p), p), 1e-7) << round;
            if (i > 0) {
                EXPECT_EQ(now.segments[i - 1].b, g.a);
            }
        }
    }
    sheet.sources = {};
    sheet.sources.segments = {{2, s.vertices[s.triangles[2][0]], s.vertices[s.triangles[2][0]]}}; // a point stays one
    EXPECT_EQ(refined(sheet, 1.5).sheet.sources.segments.size(), 1U);
}

TEST(RefinedSheet, OrderOfTheFileDoesNotShow) {
    auto mesh = surface::grid(30, 20, 6, 4, bent);
    Notes notes;
    surface::Sheet first, second;
    first.surface = surface::connect(mesh, notes);
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    std::reverse(mesh.vertices.begin(), mesh.vertices.end());
    const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
    for (auto& t : mesh.triangles) t = {n - 1 - t[1], n - 1 - t[2], n - 1 - t[0]};
    second.surface = surface::connect(mesh, notes);
    first.sources.vertices = {3}, second.sources.vertices = {n - 1 - 3};
    const RefinedSheet f = refined(first, 2), g = refined(second, 2);
    EXPECT_EQ(f.sheet.surface.vertices, g.sheet.surface.vertices);
    EXPECT_EQ(f.sheet.surface.triangles, g.sheet.surface.triangles);
    EXPECT_EQ(f.sheet.surface.twin, g.sheet.surface.twin);
    EXPECT_EQ(f.sheet.sources.vertices, g.sheet.sources.vertices);
}

} // namespace
} // namespace filum::surfpath
