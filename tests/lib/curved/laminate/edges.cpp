#include "laminate/edges.hpp"

#include "../../shapes/surface/grid.hpp"
#include "base/error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace filum::laminate {
namespace {

using geom::Vec2;

BaseSurface plate() { // 40 x 40 mm, a mm apart, the middle at (0, 0); faces: 1 where x < 0, else 2
    Notes notes;
    BaseSurface out{surface::connect(surface::grid(40, 40, 40, 40,
                                                   [](Vec2 p) {
                                                       return Vec3{p.x - 20, p.y - 20, 0};
                                                   }),
                                     notes),
                    {}};
    for (const auto& t : out.surface.triangles) {
        const auto& v = out.surface.vertices;
        out.faces.push_back(v[t[0]].x + v[t[1]].x + v[t[2]].x < 0 ? 1 : 2);
    }
    return out;
}

Area circle(double radius, double x = 0, double way = 1) { // way 1: counter-clockwise
    Area out;
    out.curves.emplace_back();
    for (int i = 0; i < 60; ++i) {
        const double a = way * i * std::numbers::pi / 30;
        out.curves[0].push_back({x + radius * std::cos(a), radius * std::sin(a), 0});
    }
    return out;
}

double out_from(const Vec3& p, double x, double radius) { return std::hypot(p.x - x, p.y) - radius; }

TEST(Edges, OfCurvesAreToTheirLeft) {
    const BaseSurface base = plate();
    Notes notes;
    const Edge in = edge_of(base, circle(12), 0.5, notes), out = edge_of(base, circle(12, 0, -1), 0.5, notes);
    for (std::size_t v = 0; v < in.size(); ++v) {
        EXPECT_NEAR(in[v], out_from(base.surface.vertices[v], 0, 12), 0.03);
        EXPECT_NEAR(out[v], -in[v], 1e-9);
    }
    EXPECT_TRUE(notes.empty());
    auto high = circle(12);
    for (auto& p : high.curves[0]) p.z = 3;
    edge_of(base, high, 0.5, notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NEAR(notes[0].amount, 3, 1e-6);
    EXPECT_TRUE(edge_of(base, {}, 0.5, notes).empty());
}

TEST(Edges, AlongRimsAreNone) {
    const BaseSurface base = plate();
    Notes notes;
    Area within; // the left half, drawn a little beyond the rims of it
    within.curves = {{{-20.1, -20.1, 0}, {4, -20.1, 0}, {4, 20.1, 0}, {-20.1, 20.1, 0}}};
    const Edge edge = edge_of(base, within, 0.5, notes);
    for (std::size_t v = 0; v < edge.size(); ++v) {
        const Vec3& p = base.surface.vertices[v];
        if (std::abs(p.x - 4) < 1e-9) continue;
        if (std::abs(p.y) < 19.1) {
            EXPECT_NEAR(edge[v], p.x - 4, 0.02);
        }
        EXPECT_EQ(edge[v] < 0, p.x < 4) << p.x << " " << p.y << " " << edge[v];
    }
}

TEST(Edges, OfFacesAreTheirBorders) {
    const BaseSurface base = plate();
    Notes notes;
    Area within;
    within.faces = {2};
    const Edge edge = edge_of(base, within, 0.5, notes);
    for (std::size_t v = 0; v < edge.size(); ++v) EXPECT_NEAR(edge[v], -base.surface.vertices[v].x, 1e-6);
    within.faces = {7};
    EXPECT_THROW(edge_of(base, within, 0.5, notes), Error);
}

TEST(Edges, PliesThatEndAlikeBecomeARamp) {
    const BaseSurface base = plate();
    Notes notes;
    const std::vector<Ply> plies(4, Ply{.spacing = 1, .height = 0.25});
    const Edge around = edge_of(base, circle(16), 0.5, notes);
    std::vector<Edge> edges{around, around, around, {}};
    make_ramps(base.surface, plies, 12, edges, notes);
    for (std::size_t v = 0; v < around.size(); ++v) {
        const double r = out_from(base.surface.vertices[v], 0, 0);
        EXPECT_NEAR(edges[1][v], r - 13, 0.05);
        EXPECT_NEAR(edges[2][v], r - 10, 0.05);
    }
    ASSERT_EQ(notes.size(), 2U);
    EXPECT_NEAR(notes[1].amount, 6, 0.1);
    EXPECT_EQ(notes[1].layer, 2);
    // The last ply lies on all: it nowhere slopes more than that, and is as high as those below.
    const auto below = heights_below(plies, edges, around.size(), 12);
    const auto& s = base.surface;
    for (std::uint32_t h = 0; h < s.twin.size(); ++h)
        EXPECT_LT(std::abs(below[3][s.tail(h)] - below[3][s.head(h)]), surface::side_length(s, h) / 12 * 1.01);
    for (std::size_t v = 0; v < around.size(); ++v) {
        const double r = out_from(s.vertices[v], 0, 0);
        if (r < 9.9) {
            EXPECT_NEAR(below[3][v], 0.75, 1e-9);
        }
        if (r > 19.1) {
            EXPECT_NEAR(below[3][v], 0, 1e-9);
        }
        EXPECT_EQ(below[0][v], 0);
    }
}

TEST(Edges, WhatCannotBeARampIsTold) {
    const BaseSurface base = plate();
    Notes notes;
    const std::vector<Ply> plies(2, Ply{.spacing = 1, .height = 0.25});
    std::vector<Edge> edges{edge_of(base, circle(8, -4), 0.5, notes), edge_of(base, circle(8, 4), 0.5, notes)};
    const auto before = edges;
    make_ramps(base.surface, plies, 12, edges, notes);
    EXPECT_EQ(edges, before);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_NEAR(notes[0].x, 0, 1.1); // the circles cross on x = 0
    EXPECT_LT(notes[0].amount, 1);
    edges = {edge_of(base, circle(8), 0.5, notes), edge_of(base, circle(8), 0.5, notes)};
    EXPECT_THROW(make_ramps(base.surface, plies, 40, edges, notes), Error);
    // One over and one under the surface have nothing to do with each other.
    auto sides = plies;
    sides[1].under = true;
    edges = {before[0], before[0]};
    make_ramps(base.surface, sides, 12, edges, notes);
    EXPECT_EQ(edges[1], before[0]);
}

} // namespace
} // namespace filum::laminate
