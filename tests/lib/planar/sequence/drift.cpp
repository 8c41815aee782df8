// How far regions move along a column bounds how their distances change.
#include "sequence/drift.hpp"

#include "worlds.hpp"

#include <gtest/gtest.h>

namespace filum::sequence {
namespace {

// A ring of `n` corners about the origin, its corners moved at random by up to `by`, begun at any corner, with a vertex
// on an edge here and there.
polygon::Loops ring(Random& random, double radius, std::size_t n, double by) {
    polygon::Loops out;
    for (const double r : {radius, radius - 1}) {
        std::vector<geom::Vec2> corner, loop;
        for (std::size_t k = 0; k < n; ++k) {
            const double angle =
                (r == radius ? 2 : -2) * 3.14159265358979 * static_cast<double>(k) / static_cast<double>(n);
            corner.push_back(
                {r * std::cos(angle) + uniform(random, -by, by), r * std::sin(angle) + uniform(random, -by, by)});
        }
        const std::size_t first = random() % n;
        for (std::size_t k = 0; k < n; ++k) {
            const auto a = corner[(first + k) % n], b = corner[(first + k + 1) % n];
            loop.push_back(a);
            if (random() % 4 == 0) loop.push_back(geom::lerp(a, b, uniform(random, 0.1, 0.9)));
        }
        out.add(loop);
    }
    return out;
}

double reach_of(const polygon::Loops& a) {
    double most = 0;
    for (const auto p : a.points) most = std::max(most, geom::norm(p));
    return most;
}

TEST(Drift, BoundsDistances) {
    Random random(3);
    std::size_t known = 0;
    for (int i = 0; i < 300; ++i) {
        const double by = i % 3 == 0 ? 0 : uniform(random, 0, 0.2);
        const auto a = ring(random, 10, 12, by), b = ring(random, 10, i % 5 == 0 ? 13 : 12, by);
        const auto other = ring(random, uniform(random, 3, 20), 9, 0.1);
        const Movement by_both = movement(a, b);
        const double moved = geom::norm(by_both.shift) + std::abs(by_both.scale - 1) * reach_of(a) + by_both.rest;
        known += std::isfinite(moved) ? 1 : 0;
        EXPECT_TRUE(by > 0 || i % 5 == 0 || moved < 1e-9);
        EXPECT_LT(moved, 1.5); // corners of 12 and 13 are up to .6 mm apart
        const double change = distance(outline(a), outline(other)) - distance(outline(b), outline(other));
        EXPECT_LE(std::abs(change), moved + 1e-9);
    }
    EXPECT_EQ(known, 300U);
    polygon::Loops one; // the numbers of loops differ
    one.add(ring(random, 10, 12, 0)[0]);
    EXPECT_EQ(movement(ring(random, 10, 12, 0), one).rest, std::numeric_limits<double>::infinity());
}

// The same circle by other corners: only their number and places differ.
TEST(Drift, CornersOfACircleDoNotMatter) {
    for (const std::size_t n : {40U, 300U, 301U})
        for (const double turn : {0.0, 0.01, 1.0, 3.0}) {
            const auto circle = [](std::size_t corners, double from, double x) {
                polygon::Loops out;
                std::vector<geom::Vec2> loop;
                for (std::size_t k = 0; k < corners; ++k) {
                    const double at =
                        from + 2 * 3.14159265358979 * static_cast<double>(k) / static_cast<double>(corners);
                    loop.push_back({x + 10 * std::cos(at), 10 * std::sin(at)});
                }
                out.add(loop);
                return out;
            };
            const Movement m = movement(circle(40, 0, 0), circle(n, turn, 5));
            EXPECT_NEAR(m.shift.x, 5, 0.1) << n << ' ' << turn;
            EXPECT_LT(m.rest, 0.2) << n << ' ' << turn; // a chord's height is .03 mm
        }
}

Bounds exactly(double d) { return {d, d}; }

polygon::Loops shifted(polygon::Loops a, geom::Vec2 by) {
    for (auto& p : a.points) p = p + by;
    return a;
}

TEST(Drift, ColumnsThatLeanTheSameWayKeepTheirDistance) {
    Random random(8);
    for (int i = 0; i < 100; ++i) {
        const geom::Vec2 lean{uniform(random, -1, 1), uniform(random, -1, 1)};
        const double by = i % 2 == 0 ? 0 : 0.05;
        std::vector<Outline> outlines;
        std::vector<Index> inner, outer;
        for (Index l = 0; l < 6; ++l) {
            inner.push_back(static_cast<Index>(outlines.size()));
            outlines.push_back(outline(shifted(ring(random, 6, 12, by), static_cast<double>(l) * lean)));
            outer.push_back(static_cast<Index>(outlines.size()));
            outlines.push_back(outline(shifted(ring(random, 15, 12, by), static_cast<double>(l) * lean)));
        }
        const Drift a = drift(inner, outlines), c = drift(outer, outlines);
        for (int trial = 0; trial < 20; ++trial) {
            const auto place = [&] { return static_cast<std::size_t>(random() % 6); };
            const std::size_t from = place(), to = place(), m = place(), n = place();
            const Bounds bounds =
                relative(a, from, to, c, m, n, exactly(distance(outlines[inner[from]], outlines[outer[m]])));
            const double after = distance(outlines[inner[to]], outlines[outer[n]]);
            EXPECT_LE(bounds.least, after + 1e-9);
            EXPECT_GE(bounds.most, after - 1e-9);
        }
        if (by == 0) {
            const Bounds same = relative(a, 0, 5, c, 0, 5, {3, 3});
            EXPECT_NEAR(same.least, 3, 0.01);
            EXPECT_NEAR(same.most, 3, 0.01);
        }
    }
}

// Cones and pyramids with one tip, turned and moved between: distances grow with the scale, as do those that the
// carriage sees.
TEST(Drift, ColumnsThatGrowTheSameWayKeepTheirProportions) {
    Random random(9);
    for (int i = 0; i < 100; ++i) {
        const geom::Vec2 lean{uniform(random, -1, 1), uniform(random, -1, 1)};
        const double growth = uniform(random, 0.9, 1.1), by = i % 2 == 0 ? 0 : 0.05;
        std::vector<Outline> outlines;
        std::vector<Index> inner, outer;
        const auto add = [&](std::vector<Index>& column, double radius, Index l) {
            auto loops = ring(random, radius, 12, by);
            for (geom::Vec2& p : loops.points) p = std::pow(growth, l) * p + static_cast<double>(l) * lean;
            column.push_back(static_cast<Index>(outlines.size()));
            outlines.push_back(outline(loops));
        };
        for (Index l = 0; l < 6; ++l) {
            add(inner, 6, l);
            add(outer, 15, l);
        }
        const geom::Vec2 idle = i % 3 == 0 ? geom::Vec2{} : geom::Vec2{30, -4};
        const Drift a = shifted(drift(inner, outlines), idle), c = drift(outer, outlines);
        for (int trial = 0; trial < 20; ++trial) {
            const auto place = [&] { return static_cast<std::size_t>(random() % 6); };
            const std::size_t from = place(), to = place(), m = place(), n = place();
            const auto over = [&](std::size_t at) { return shifted(outlines[inner[at]], idle); };
            const Outline before = over(from), after = over(to);
            const Bounds near = relative(a, from, to, c, m, n, exactly(distance(before, outlines[outer[m]])));
            EXPECT_LE(near.least, distance(after, outlines[outer[n]]) + 1e-9);
            EXPECT_GE(near.most, distance(after, outlines[outer[n]]) - 1e-9);
            const Bounds seen = relative(a, from, to, c, m, n, carriage_bounds(before, outlines[outer[m]], 8, 5));
            const Bounds then = carriage_bounds(after, outlines[outer[n]], 8, 5);
            EXPECT_LE(seen.least, then.most + 1e-9);
            EXPECT_GE(seen.most, then.least - 1e-9);
        }
        if (by == 0 && idle == geom::Vec2{}) {
            const double scale = std::pow(growth, 5);
            const Bounds same = relative(a, 0, 5, c, 0, 5, {3, 3});
            EXPECT_NEAR(same.least, 3 * scale, 0.02);
            EXPECT_NEAR(same.most, 3 * scale, 0.02);
        }
    }
}

struct Nest {
    const char* name;
    double narrowing, lean, own_lean; // mm per layer
    double twist = 0;                 // per layer
    std::size_t further_corners = 0;  // of every third layer
    double shrinking = 0;             // share of the size, per layer
};

constexpr Nest kNests[] = {{"straight", 0, 0, 0},
                           {"conical", 0.03, 0, 0},
                           {"flat cones", 0.15, 0, 0},
                           {"leaning", 0, 0.3, 0},
                           {"leaning apart", 0.02, 0.1, 0.05},
                           {"each leaning", 0, 0, 0.1},
                           {"twisted", 0, 0, 0, 0.05},
                           {"other corners", 0, 0.3, 0, 0.02, 3},
                           {"pyramids", 0, 0, 0, 0, 0, 0.01},
                           {"leaning pyramids", 0, 0.2, 0.01, 0, 3, 0.02}};

// Rings one in the other, and what a plain look at all pairs says.
struct NestOfRings {
    Graph g;
    Columns columns;
    std::vector<Outline> outlines;
    machine::Head head;
    std::vector<Pair> plain;
};

NestOfRings nest(const Nest& kind, Random& random) {
    constexpr Index kRings = 5, kLayers = 30;
    NestOfRings out;
    Graph& g = out.g;
    out.columns.member.resize(kRings);
    std::vector<Pair> support;
    for (Index l = 0; l < kLayers; ++l)
        for (Index i = 0; i < kRings; ++i) {
            const Index v = g.size();
            g.node.push_back({l, 0.2 * (l + 1), {0, 0}});
            const geom::Vec2 at{l * (kind.lean + kind.own_lean * i), l * kind.own_lean * (i % 2)};
            auto loops =
                ring(random, 20 - 3.0 * i - kind.narrowing * l, 16 + (l % 3 == 0 ? kind.further_corners : 0), 0);
            const double turn = kind.twist * l, c = std::cos(turn), sine = std::sin(turn);
            for (geom::Vec2& p : loops.points)
                p = (1 - kind.shrinking * l) * geom::Vec2{c * p.x - sine * p.y, sine * p.x + c * p.y};
            out.outlines.push_back(outline(shifted(loops, at)));
            out.columns.member[i].push_back(v);
            out.columns.of.push_back(i);
            if (l > 0) support.emplace_back(v - kRings, v);
        }
    g.up = g.after = arcs(g.size(), support);
    g.down = g.before = reversed(g.after);
    out.head.cone_height = 3;
    out.head.carriage_x = out.head.carriage_y = 24;
    for (Index a = 0; a < kRings; ++a)
        for (Index c = 0; c < kRings; ++c) {
            Index least = kNone; // of column c, what the regions above wait for
            for (Index l = kLayers; l-- > 0 && a != c;) {
                const Index v = out.columns.member[a][l];
                for (Index k = l + 1; k < std::min(least, kLayers); ++k) {
                    const Index u = out.columns.member[c][k];
                    const Reach r = reach(out.head, g.node[u].z - g.node[v].z);
                    if (!within(out.outlines[v], out.outlines[u], r)) continue;
                    out.plain.emplace_back(v, u);
                    least = k;
                    break;
                }
            }
        }
    std::sort(out.plain.begin(), out.plain.end());
    return out;
}

TEST(Drift, CollisionsOfNestedRingsAreThoseOfAllPairs) {
    Random random(5);
    for (const Nest& kind : kNests) {
        const NestOfRings n = nest(kind, random);
        DistanceWork work;
        auto found = collisions(n.g, n.columns, n.outlines, n.head, work);
        std::sort(found.begin(), found.end());
        EXPECT_FALSE(n.plain.empty());
        EXPECT_EQ(found, n.plain) << kind.name;
        EXPECT_EQ(work.assumed, 0U);
    }
}

// With little work or none, what is not measured counts as a collision: every collision is still implied, and all
// precedences lead upwards.
TEST(Drift, WithoutWorkNoCollisionIsMissed) {
    Random random(6);
    for (const Nest& kind : kNests)
        for (const std::uint64_t limit : {0, 3000, 30000}) {
            const NestOfRings n = nest(kind, random);
            DistanceWork work;
            work.limit = limit;
            const auto found = collisions(n.g, n.columns, n.outlines, n.head, work);
            EXPECT_TRUE(limit > 0 || work.assumed > 0);
            EXPECT_LE(work.steps, limit + 5000) << kind.name; // a distance that was begun is finished
            for (const auto& [v, u] : found) EXPECT_LT(n.g.node[v].layer, n.g.node[u].layer);
            for (const auto& [v, u] : n.plain)
                EXPECT_TRUE(std::ranges::any_of(found, [&, v = v, u = u](const Pair& p) {
                    return n.columns.of[p.first] == n.columns.of[v] && p.first >= v &&
                           n.columns.of[p.second] == n.columns.of[u] && p.second <= u;
                })) << kind.name;
        }
}

} // namespace
} // namespace filum::sequence
