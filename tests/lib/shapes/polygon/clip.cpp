// Invariants of the boolean operations, offsets, splitting and simplifying, on random areas.
#include "polygon/clip.hpp"

#include "geom/segment.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace filum::polygon {
namespace {

// A star-shaped loop about a random centre.
void add_star(Loops& out, std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    const Vec2 centre{20 * unit(random), 20 * unit(random)};
    const std::size_t n = 3 + random() % 40;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
        const double radius = 1 + 6 * unit(random);
        out.points.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
    }
    out.close();
}

Loops random_area(unsigned seed) {
    std::mt19937 random(seed);
    Loops out;
    for (unsigned k = 0; k < 1 + seed % 5; ++k) add_star(out, random);
    return out;
}

// Slack in mm2 for the grid: its step times the length of the outlines.
double slack(const Loops& a) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += perimeter(a[i]);
    return 1e-6 + 2e-4 * sum;
}

double area(const Loops& a) { return signed_area(a); }

double distance_to(const Loops& a, Vec2 p) {
    double best = 1e300;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < a[i].size(); ++k)
            best = std::min(best, geom::point_segment_distance(a[i][k], a[i][(k + 1) % a[i].size()], p));
    return best;
}

TEST(Booleans, AreasAddUp) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        const Loops a = unite(random_area(seed)), b = unite(random_area(seed + 1000));
        const double s = slack(a) + slack(b);
        const double both = area(intersect(a, b)), any = area(unite(a, b));
        EXPECT_NEAR(any + both, area(a) + area(b), s) << seed;
        EXPECT_NEAR(area(subtract(a, b)), area(a) - both, s) << seed;
        EXPECT_NEAR(area(intersect(a, a)), area(a), s);
        EXPECT_NEAR(area(subtract(a, a)), 0, s);
        EXPECT_LE(both, std::min(area(a), area(b)) + s);
    }
}

TEST(Booleans, APointIsInTheResultWhereItShouldBe) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> coordinate(-5, 25);
    for (unsigned seed = 0; seed < 30; ++seed) {
        const Loops a = unite(random_area(seed)), b = unite(random_area(seed + 500));
        const Loops both = intersect(a, b), any = unite(a, b), rest = subtract(a, b);
        for (int k = 0; k < 100; ++k) {
            const Vec2 p{coordinate(random), coordinate(random)};
            if (std::min(distance_to(a, p), distance_to(b, p)) < 1e-3) continue; // on the grid's edge
            const bool in_a = contains(a, p), in_b = contains(b, p);
            EXPECT_EQ(contains(both, p), in_a && in_b);
            EXPECT_EQ(contains(any, p), in_a || in_b);
            EXPECT_EQ(contains(rest, p), in_a && !in_b);
        }
    }
}

TEST(Booleans, ResultsAreSimple) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Loops a = unite(random_area(seed));
        std::vector<std::pair<Vec2, Vec2>> edges;
        for (std::size_t i = 0; i < a.size(); ++i)
            for (std::size_t k = 0; k < a[i].size(); ++k) edges.emplace_back(a[i][k], a[i][(k + 1) % a[i].size()]);
        for (std::size_t i = 0; i < edges.size(); ++i)
            for (std::size_t k = i + 1; k < edges.size(); ++k)
                ASSERT_FALSE(geom::cross_properly(edges[i].first, edges[i].second, edges[k].first, edges[k].second))
                    << seed;
    }
}

// Overlapping quadrilaterals along a line, as the patches over the hairlines of a noisy outline.
TEST(Booleans, HalvesOfAListUniteToTheSameArea) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> coordinate(-0.2, 0.2);
    for (const int count : {1, 40, 251, 3000}) {
        Loops patches;
        for (int k = 0; k < count; ++k) {
            const Vec2 at{0.03 * k, coordinate(random)};
            const double x = 0.15 + coordinate(random) / 2, y = 0.15 + coordinate(random) / 2;
            patches.add(std::vector<Vec2>{at - Vec2{x, 0}, at - Vec2{0, y}, at + Vec2{x, 0}, at + Vec2{0, y}});
        }
        const Loops halves = unite_by_halves(patches), once = unite(patches);
        EXPECT_NEAR(area(halves), area(once), slack(once) + slack(patches)) << count;
        EXPECT_NEAR(area(subtract(halves, once)) + area(subtract(once, halves)), 0, slack(once) + slack(patches));
    }
}

TEST(Offset, OutlinesKeepTheirDistance) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Loops a = unite(random_area(seed));
        for (const double delta : {-0.8, -0.2, 0.3, 1.5}) {
            const Loops moved = offset(a, delta);
            for (const Vec2 p : moved.points) EXPECT_NEAR(distance_to(a, p), std::abs(delta), 0.006) << seed;
            if (delta > 0)
                EXPECT_GT(area(moved), area(a));
            else
                EXPECT_LT(area(moved), area(a));
        }
        EXPECT_NEAR(area(offset(a, 0)), area(a), slack(a));
    }
}

TEST(Offset, ASquareGrowsAsSteinerSays) {
    Loops square;
    const Vec2 corners[] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    square.add(corners);
    EXPECT_NEAR(area(offset(square, 1)), 100 + 40 + std::numbers::pi, 0.02);
    EXPECT_NEAR(area(offset(square, -1)), 64, 0.001);
    EXPECT_TRUE(offset(square, -5.1).empty());
}

TEST(Offset, ALineBecomesABead) {
    const std::vector<Vec2> line{{0, 0}, {3, 0}, {3, 4}};
    const Loops bead = around(line, 0.2, 0.0005);
    ASSERT_EQ(bead.size(), 1U);
    // straight parts, round ends, the wedge outside the corner and the overlap inside it
    const double r = 0.2, pi = 3.14159265358979;
    EXPECT_NEAR(signed_area(bead), 7 * 2 * r + pi * r * r + pi * r * r / 4 - r * r, 1e-3);
    EXPECT_NEAR(signed_area(around(std::vector<Vec2>{{1, 1}}, 0.5, 0.0005)), pi / 4, 2e-3);
}

TEST(Split, PartsAreDisjointConnectedAndComplete) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        const Loops a = unite(random_area(seed));
        const Parts parts = split(a);
        ASSERT_EQ(parts.part.size(), parts.parent.size());
        double sum = 0;
        for (std::size_t i = 0; i < parts.part.size(); ++i) {
            const Loops& part = parts.part[i];
            EXPECT_GT(signed_area(part[0]), 0);
            for (std::size_t h = 1; h < part.size(); ++h) {
                EXPECT_LT(signed_area(part[h]), 0);
            }
            sum += area(part);
            const int parent = parts.parent[i];
            EXPECT_LT(parent, static_cast<int>(parts.part.size()));
            if (parent >= 0) {
                Loops outer;
                outer.add(parts.part[static_cast<std::size_t>(parent)][0]);
                EXPECT_TRUE(contains(outer, part[0][0]));
            }
        }
        EXPECT_NEAR(sum, area(a), slack(a)) << seed;
    }
}

// The difference may share outlines with what it is taken from, and the result is the same up to the tolerance of arcs.
TEST(Opened, ADifferenceIsThatOfOutlinesMovedApart) {
    constexpr double kArcs = 0.002;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Loops a = unite(random_area(seed));
        const Loops others[] = {unite(random_area(seed + 1000)), intersect(a, unite(random_area(seed + 1000))), a, {}};
        for (const Loops& b : others)
            for (const double radius : {0.02, 0.2}) {
                const Loops moved = opened_difference(a, b, radius, kArcs);
                const Loops direct = opened(subtract(a, b), radius, kArcs);
                EXPECT_TRUE(offset(subtract(moved, direct), -4 * kArcs).empty()) << seed << " " << radius;
                EXPECT_TRUE(offset(subtract(direct, moved), -4 * kArcs).empty()) << seed << " " << radius;
            }
    }
}

TEST(Split, AnIslandInAHoleHasItsRingAsParent) {
    Loops a;
    const Vec2 outer[] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, hole[] = {{1, 1}, {1, 9}, {9, 9}, {9, 1}},
               island[] = {{3, 3}, {7, 3}, {7, 7}, {3, 7}};
    a.add(outer);
    a.add(hole);
    a.add(island);
    const Parts parts = split(a);
    ASSERT_EQ(parts.part.size(), 2U);
    EXPECT_EQ(parts.part[0].size(), 2U);
    EXPECT_EQ(parts.parent, (std::vector<int>{-1, 0}));
}

TEST(Simplify, NothingMovesFartherThanTheTolerance) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        const Loops a = unite(random_area(seed));
        for (const double tolerance : {0.001, 0.05, 0.5}) {
            const Loops s = simplify(a, tolerance);
            EXPECT_LE(s.points.size(), a.points.size());
            if (s.size() != a.size()) continue; // a loop thinner than the tolerance vanished
            for (std::size_t i = 0; i < a.size(); ++i) {
                Loops one;
                one.add(s[i]);
                for (const Vec2 p : a[i]) EXPECT_LE(distance_to(one, p), tolerance + 1e-12);
            }
        }
    }
}

TEST(Simplify, PointsOnStraightLinesGo) {
    Loops a;
    for (int i = 0; i < 100; ++i) a.points.push_back({0.1 * i, 0});
    for (int i = 0; i < 100; ++i) a.points.push_back({10, 0.1 * i});
    a.points.push_back({10, 10});
    a.close();
    EXPECT_EQ(simplify(a, 1e-6)[0].size(), 3U);
}

// An upright wall has the same loop in every layer, wherever its contours begin.
TEST(Clip, LoopsBeginAtCorners) {
    Loops square;
    square.add(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    for (const double at : {0.1, 1.7, 3.9}) {
        Loops begun;
        begun.add(std::vector<Vec2>{{0, at}, {0, 0}, {4, 0}, {4, 4}, {0, 4}});
        EXPECT_EQ(without_flat_starts(begun).points, square.points);
        begun.points[0].x = 0.001; // a dent
        EXPECT_EQ(without_flat_starts(begun).points, begun.points);
    }
    EXPECT_EQ(without_flat_starts(square).points, square.points);
}

} // namespace
} // namespace filum::polygon
