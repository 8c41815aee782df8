#include "surface/meet.hpp"
#include "grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace filum::surface {
namespace {

using geom::Vec2;

Surface surface_of(mesh::Mesh m) {
    Notes notes;
    return connect(std::move(m), notes);
}

double length(const std::vector<Segment>& lines) {
    double sum = 0;
    for (const auto& s : lines) sum += distance(s.a, s.b);
    return sum;
}

void expect_in_triangles(const Surface& s, const std::vector<Segment>& lines) {
    for (const auto& l : lines)
        for (const Vec3& p : {l.a, l.b}) EXPECT_LT(distance(nearest_in(s, l.triangle, p), p), 1e-9);
}

TEST(Meet, APlaneOfTrianglesCutsAsAPlaneDoes) {
    const Surface s = surface_of(grid(10, 8, 13, 9, [](Vec2 p) { return Vec3{p.x, p.y, std::sin(p.x) * p.y / 5}; }));
    const double k = std::sqrt(0.5);
    const auto wall = grid(40, 40, 7, 5, [&](Vec2 p) { // x + y = 9, oblique to the grid of the wall
        return Vec3{4.5 + k * (p.x - 20.3), 4.5 - k * (p.x - 20.3), p.y - 17.1};
    });
    const Intersection m = meet(s, wall);
    const auto cut = section(s, {{1, 1, 0}, 9});
    EXPECT_NEAR(length(m.segments), length(cut), 1e-6);
    EXPECT_NEAR(m.crossing, length(cut), 1e-6);
    EXPECT_EQ(m.touching, 0);
    EXPECT_EQ(m.flush, 0);
    for (const auto& l : m.segments) EXPECT_NEAR(l.a.x + l.a.y + l.b.x + l.b.y, 18, 1e-9);
    expect_in_triangles(s, m.segments);
}

TEST(Meet, TheSideThatTheMeshFacesIsToTheLeft) {
    const Surface s = surface_of(flat_grid(10, 10, 7, 7));
    auto wall = grid(30, 10, 3, 2, [](Vec2 p) { return Vec3{4.3, p.x - 10, p.y - 5}; }); // faces +x
    for (const double way : {-1.0, 1.0}) {
        const auto lines = meet(s, wall).segments;
        EXPECT_NEAR(length(lines), 10, 1e-9);
        for (const auto& l : lines) EXPECT_GT(way * (l.b.y - l.a.y), 0);
        for (auto& t : wall.triangles) std::swap(t[1], t[2]);
    }
}

TEST(Meet, ThroughVerticesAndAlongEdgesNothingIsLostOrDoubled) {
    const Surface s = surface_of(flat_grid(10, 10, 10, 10));
    const auto wall = grid(10, 10, 10, 10, [](Vec2 p) { return Vec3{3, p.x, p.y - 5}; }); // along the edges at x = 3
    const auto lines = meet(s, wall).segments;
    std::vector<std::pair<double, double>> ways;
    for (const auto& l : lines) {
        EXPECT_EQ(l.a.x, 3);
        ways.push_back({std::min(l.a.y, l.b.y), std::max(l.a.y, l.b.y)});
    }
    std::sort(ways.begin(), ways.end());
    ways.erase(std::unique(ways.begin(), ways.end()), ways.end()); // an edge belongs to both triangles
    double end = 0;
    for (const auto& [from, to] : ways) {
        EXPECT_EQ(from, end);
        end = to;
    }
    EXPECT_EQ(end, 10);
}

TEST(Meet, ASharedBorderCountsThoughItsTrianglesDiffer) {
    // two halves of a cylinder of radius 5 that share a border: the circle at z = 0
    const auto round = [](double angle, double z) { return Vec3{5 * std::cos(angle), 5 * std::sin(angle), z}; };
    const Surface upper = surface_of(grid(3, 4, 23, 31, [&](Vec2 p) { return round(p.x, p.y); }));
    const auto flange = grid(3, 6, 37, 10, [&](Vec2 p) { // a ring in the plane z = 0, inwards and outwards
        return (2 + p.y) / 5 * round(p.x, 0);
    });
    const Intersection m = meet(upper, flange);
    double along = 0;
    for (const auto& l : m.segments) {
        EXPECT_NEAR(l.a.z, 0, 1e-9);
        along += distance(l.a, l.b);
    }
    EXPECT_NEAR(along, 15, 0.02);
    const auto other = grid(3, 6, 29, 10, [&](Vec2 p) { return (5 + p.y) / 5 * round(p.x, 0); }); // outwards only
    const Intersection rim = meet(upper, other);
    EXPECT_NEAR(rim.touching, 15, 0.02); // chords of both lie up to 0.008 mm apart
    EXPECT_EQ(rim.crossing, 0);
    expect_in_triangles(upper, rim.segments);
}

TEST(Meet, ARimThatOnlyPassesTheMeshDoesNotCount) {
    const Surface s = surface_of(flat_grid(10, 10, 10, 10));
    const auto wall = grid(30, 10, 3, 2, [](Vec2 p) { return Vec3{4.3 + 0.2 * (p.x - 15), p.x - 10, p.y - 5}; });
    const Intersection m = meet(s, wall);
    EXPECT_EQ(m.touching, 0);
    EXPECT_NEAR(m.crossing, 10 * std::sqrt(1.04), 1e-9);
}

TEST(Meet, WhatLiesOnTheMeshIsToldByItsArea) {
    const Surface s = surface_of(flat_grid(10, 10, 5, 5));
    const auto patch = grid(3, 3, 2, 2, [](Vec2 p) { return Vec3{2.7 + p.x, 3.1 + p.y, 0}; });
    const Intersection m = meet(s, patch);
    EXPECT_NEAR(m.flush, 9, 1e-9);
    EXPECT_GT(length(m.segments), 12);
    for (const auto& l : m.segments)
        for (const Vec3& p : {l.a, l.b}) EXPECT_TRUE(p.x > 2.69 && p.x < 5.71 && p.y > 3.09 && p.y < 6.11 && p.z == 0);
}

TEST(Meet, NothingWhereTheyAreApart) {
    const Surface s = surface_of(flat_grid(10, 10, 5, 5));
    EXPECT_TRUE(meet(s, grid(9, 9, 2, 2, [](Vec2 p) { return Vec3{p.x, p.y, 0.5}; })).segments.empty());
    EXPECT_TRUE(meet(s, mesh::Mesh{}).segments.empty());
    const mesh::Mesh flat{{{1, 1, 0}, {2, 2, 0}, {3, 3, 0}}, {{0, 1, 2}}}; // without area
    EXPECT_TRUE(meet(s, flat).segments.empty());
}

} // namespace
} // namespace filum::surface
