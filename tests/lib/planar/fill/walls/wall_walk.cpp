#include "fill/walls/wall_walk.hpp"

#include "../pattern_check.hpp"
#include "fill/fill.hpp"

#include <numeric>

namespace filum::fill {

using namespace walls;

namespace {

using namespace test;

constexpr double kWall = 0.36; // mm; thinner than the bead of 0.4

Loops plate() { return rectangle(0, 0, 12, kWall); }
Loops tee() { return regions_of(polygon::unite(plate(), rectangle(4, 0, 4 + kWall, 6))).at(0); }
Loops ring() { return polygon::subtract(disc({0, 0}, 5, 96), disc({0, 0}, 5 - kWall, 96)); }
Loops grid(int columns, int rows) {
    Loops area = rectangle(0, 0, 3 * columns + kWall, 3 * rows + kWall);
    for (int i = 0; i < columns; ++i)
        for (int j = 0; j < rows; ++j)
            area = polygon::subtract(area, rectangle(3 * i + kWall, 3 * j + kWall, 3 * i + 3, 3 * j + 3));
    return area;
}
Loops fishbone(int ribs) {
    Loops area = rectangle(0, 0, 2 * ribs + 2, kWall);
    for (int k = 0; k < ribs; ++k) {
        area = polygon::unite(area, rectangle(2 * k + 1, -3, 2 * k + 1 + kWall, 0.1));
        area = polygon::unite(area, rectangle(2 * k + 2, 0.1, 2 * k + 2 + kWall, 3));
    }
    return regions_of(area).at(0);
}

double total(const WallGraph& g) {
    return std::accumulate(g.walls.begin(), g.walls.end(), 0.0, [](double s, const Wall& w) { return s + w.length; });
}

WallWalk walk(const Loops& area) { return wall_walk(wall_graph(area, 0.4).value()); }

TEST(WallWalk, APlateIsOneLine) {
    const auto g = wall_graph(plate(), 0.4).value();
    ASSERT_EQ(g.walls.size(), 1U);
    EXPECT_EQ(g.node.size(), 2U);
    EXPECT_NEAR(g.walls[0].length, 12 - kWall, 0.01);
    const WallWalk w = wall_walk(g);
    ASSERT_EQ(w.curves.size(), 1U);
    EXPECT_FALSE(w.curves[0].closed);
    EXPECT_EQ(w.twice, 0);
    for (const double width : w.curves[0].width) EXPECT_NEAR(width, kWall, 0.002);
}

TEST(WallWalk, ATeePassesItsShortestArmTwice) {
    const WallWalk w = walk(tee());
    ASSERT_EQ(w.curves.size(), 1U);
    EXPECT_FALSE(w.curves[0].closed);
    EXPECT_NEAR(w.twice, 4, 0.1);
}

TEST(WallWalk, ARingIsClosedAndPassedOnce) {
    const WallWalk w = walk(ring());
    ASSERT_EQ(w.curves.size(), 1U);
    EXPECT_TRUE(w.curves[0].closed);
    EXPECT_EQ(w.twice, 0);
    EXPECT_NEAR(length_of(w.curves[0]), 2 * std::numbers::pi * (5 - kWall / 2), 0.1);
}

// A house can be drawn in one line; a cross in two.
TEST(WallWalk, WhatCanBeDrawnInOneLineIs) {
    EXPECT_EQ(walk(grid(1, 1)).twice, 0);
    EXPECT_EQ(walk(grid(2, 1)).twice, 0); // two odd nodes
    EXPECT_NEAR(walk(grid(3, 1)).twice, 3, 0.1);
    EXPECT_NEAR(walk(grid(2, 2)).twice, 6, 0.1); // four odd nodes on the rim, two apart by two walls each
}

TEST(WallWalk, OfATreeOnlyTheLongestPathIsSingle) {
    for (const int ribs : {1, 3, 5, 9}) {
        const auto g = wall_graph(fishbone(ribs), 0.4).value();
        const WallWalk w = wall_walk(g);
        ASSERT_EQ(w.curves.size(), 1U);
        EXPECT_NEAR(w.twice, total(g) - (2 * ribs - 1 + 6), 0.5) << ribs;
    }
}

// For any walls: one curve, as wide as they are, that covers them and does not cross itself.
void expect_walls(const Loops& area, const std::string& name) {
    const auto g = wall_graph(area, 0.4);
    ASSERT_TRUE(g) << name;
    const WallWalk w = wall_walk(*g);
    EXPECT_EQ(w.curves.size(), 1U) << name;
    expect_sound(w.curves);
    EXPECT_EQ(crossings(w.curves), 0U) << name;
    EXPECT_GT(coverage(area, w.curves, 0.06), 0.95) << name;
    EXPECT_NEAR(laid(w.curves) / polygon::signed_area(area), 1, 0.12) << name;
    EXPECT_LT(farthest_outside(area, w.curves), 0.1) << name;
    const auto passes = passes_of_walls(*g);
    std::vector<int> degree(g->node.size(), 0);
    for (std::size_t k = 0; k < passes.size(); ++k) {
        EXPECT_TRUE(passes[k] == 1 || passes[k] == 2);
        degree[g->walls[k].a] += passes[k];
        degree[g->walls[k].b] += passes[k];
    }
    const auto odd = std::count_if(degree.begin(), degree.end(), [](int d) { return d % 2 != 0; });
    EXPECT_EQ(odd, w.curves[0].closed ? 0 : 2) << name;
}

TEST(WallWalk, IsOneCurveOnAllWalls) {
    expect_walls(plate(), "plate");
    expect_walls(tee(), "tee");
    expect_walls(ring(), "ring");
    expect_walls(fishbone(4), "fishbone");
    for (int columns = 1; columns < 5; ++columns)
        for (int rows = 1; rows < 5; ++rows)
            expect_walls(grid(columns, rows), std::to_string(columns) + " x " + std::to_string(rows));
}

TEST(WallWalk, RandomGridsWithWallsMissing) {
    std::mt19937 random(7);
    for (int n = 0; n < 12; ++n) {
        Loops area = grid(3 + n % 3, 3);
        for (int k = 0; k < 6; ++k) { // takes some walls out
            const double x = 3 * static_cast<int>(random() % 3), y = 3 * static_cast<int>(random() % 3);
            area = random() % 2 == 0 ? polygon::subtract(area, rectangle(x + 0.5, y - 0.1, x + 2.5, y + 0.5))
                                     : polygon::subtract(area, rectangle(x - 0.1, y + 0.5, x + 0.5, y + 2.5));
        }
        int part = 0;
        for (const auto& piece : regions_of(area))
            if (polygon::signed_area(piece) > 1) expect_walls(piece, std::to_string(n) + "." + std::to_string(part++));
    }
}

TEST(WallWalk, FatPartsAreNoWalls) {
    EXPECT_FALSE(wall_graph(rectangle(0, 0, 5, 1), 0.4));
    EXPECT_FALSE(wall_graph(polygon::unite(plate(), rectangle(0, 0, 2, 2)), 0.4));
    EXPECT_TRUE(wall_graph(rectangle(0, 0, 5, 0.4), 0.4)); // as thick as a bead
    EXPECT_TRUE(wall_graph(rectangle(0, 0, 5, 0.56), 0.4));
    EXPECT_FALSE(wall_graph(rectangle(0, 0, 5, 0.57), 0.4)); // two beads are as near to 0.4
}

TEST(WallWalk, FillTakesItWhereAskedTo) {
    polygon::Region r;
    r.loops = tee();
    r.area = polygon::signed_area(r.loops);
    Options o;
    Notes notes;
    EXPECT_TRUE(fill(r, o, notes).curves.at(0).closed);
    EXPECT_TRUE(notes.empty());
    o.thin = Thin::single;
    EXPECT_FALSE(fill(r, o, notes).curves.at(0).closed);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::wall_doubled);
}

} // namespace
} // namespace filum::fill
