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

TEST(Drift, BoundsDistances) {
    Random random(3);
    std::size_t known = 0;
    for (int i = 0; i < 300; ++i) {
        const double by = i % 3 == 0 ? 0 : uniform(random, 0, 0.2);
        const auto a = ring(random, 10, 12, by), b = ring(random, 10, 12, by);
        const auto other = ring(random, uniform(random, 3, 20), 9, 0.1);
        const Movement by_both = movement(a, b);
        const double moved = geom::norm(by_both.shift) + by_both.rest;
        known += std::isfinite(moved) ? 1 : 0;
        EXPECT_TRUE(by > 0 || moved < 1e-9);
        const double change = distance(outline(a), outline(other)) - distance(outline(b), outline(other));
        EXPECT_LE(std::abs(change), moved + 1e-9);
    }
    EXPECT_GT(known, 250U);
    EXPECT_EQ(movement(ring(random, 10, 12, 0), ring(random, 10, 13, 0)).rest, std::numeric_limits<double>::infinity());
}

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
            const double change =
                distance(outlines[inner[to]], outlines[outer[n]]) - distance(outlines[inner[from]], outlines[outer[m]]);
            EXPECT_LE(std::abs(change), relative(a, from, to, c, m, n) + 1e-9);
        }
        if (by == 0) {
            EXPECT_LT(relative(a, 0, 5, c, 0, 5), 0.01);
        }
    }
}

// Rings one in the other, straight, narrowing with height, leaning, or each leaning in its own way: the head touches
// what a plain look at all pairs says.
TEST(Drift, CollisionsOfNestedRingsAreThoseOfAllPairs) {
    Random random(5);
    struct Kind {
        double narrowing, lean, own_lean; // mm per layer
    };
    for (const auto& [narrowing, lean, own_lean] :
         {Kind{0, 0, 0}, Kind{0.03, 0, 0}, Kind{0.15, 0, 0}, Kind{0, 0.3, 0}, Kind{0.02, 0.1, 0.05}, Kind{0, 0, 0.1}}) {
        constexpr Index kRings = 5, kLayers = 30;
        Graph g;
        Columns columns;
        columns.member.resize(kRings);
        std::vector<Outline> outlines;
        std::vector<Pair> support;
        for (Index l = 0; l < kLayers; ++l)
            for (Index i = 0; i < kRings; ++i) {
                const Index v = g.size();
                g.node.push_back({l, 0.2 * (l + 1), {0, 0}});
                const geom::Vec2 at{l * (lean + own_lean * i), l * own_lean * (i % 2)};
                outlines.push_back(outline(shifted(ring(random, 20 - 3.0 * i - narrowing * l, 16, 0), at)));
                columns.member[i].push_back(v);
                columns.of.push_back(i);
                if (l > 0) support.emplace_back(v - kRings, v);
            }
        g.up = g.after = arcs(g.size(), support);
        g.down = g.before = reversed(g.after);
        machine::Head head;
        head.cone_height = 3;
        head.carriage_x = head.carriage_y = 24;
        std::vector<Pair> plain;
        for (Index a = 0; a < kRings; ++a)
            for (Index c = 0; c < kRings; ++c) {
                Index least = kNone; // of column c, what the regions above wait for
                for (Index l = kLayers; l-- > 0 && a != c;) {
                    const Index v = columns.member[a][l];
                    for (Index k = l + 1; k < std::min(least, kLayers); ++k) {
                        const Index u = columns.member[c][k];
                        if (!within(outlines[v], outlines[u], reach(head, g.node[u].z - g.node[v].z))) continue;
                        plain.emplace_back(v, u);
                        least = k;
                        break;
                    }
                }
            }
        auto found = collisions(g, columns, outlines, head);
        std::sort(found.begin(), found.end());
        std::sort(plain.begin(), plain.end());
        EXPECT_FALSE(plain.empty());
        EXPECT_EQ(found, plain) << narrowing << ' ' << lean << ' ' << own_lean;
    }
}

} // namespace
} // namespace filum::sequence
