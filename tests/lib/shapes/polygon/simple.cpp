// is_simple against a test of all pairs of edges, on small grids where everything touches everything.
#include "polygon/simple.hpp"
#include "polygon/clip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace filum::polygon;

namespace {

struct Random {
    std::uint64_t state;
    std::uint64_t operator()(std::uint64_t n) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return (state >> 33) % n;
    }
};

long long side(Vec2 a, Vec2 b, Vec2 c) { return std::llround((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)); }
int sign(long long v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }
bool on(Vec2 a, Vec2 b, Vec2 p) {
    return side(a, b, p) == 0 && p.x >= std::min(a.x, b.x) && p.x <= std::max(a.x, b.x) && p.y >= std::min(a.y, b.y) &&
           p.y <= std::max(a.y, b.y);
}
bool touch(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    return (sign(side(a, b, c)) * sign(side(a, b, d)) < 0 && sign(side(c, d, a)) * sign(side(c, d, b)) < 0) ||
           on(a, b, c) || on(a, b, d) || on(c, d, a) || on(c, d, b);
}

// No two edges touch but neighbours in their common end, and every loop turns as its depth asks.
bool simple_by_pairs(const Loops& l) {
    struct Edge {
        Vec2 a, b;
        std::size_t loop, at, n;
    };
    std::vector<Edge> e;
    for (std::size_t i = 0; i < l.size(); ++i)
        for (std::size_t k = 0; k < l[i].size(); ++k)
            e.push_back({l[i][k], l[i][(k + 1) % l[i].size()], i, k, l[i].size()});
    for (std::size_t i = 0; i < e.size(); ++i)
        for (std::size_t j = i + 1; j < e.size(); ++j) {
            const bool next = e[i].loop == e[j].loop && (e[i].at + 1) % e[i].n == e[j].at;
            const bool before = e[i].loop == e[j].loop && (e[j].at + 1) % e[i].n == e[i].at;
            if (!next && !before) {
                if (touch(e[i].a, e[i].b, e[j].a, e[j].b)) return false;
            } else if (next ? on(e[i].a, e[i].b, e[j].b) || on(e[j].a, e[j].b, e[i].a)
                            : on(e[j].a, e[j].b, e[i].b) || on(e[i].a, e[i].b, e[j].a))
                return false;
        }
    for (std::size_t i = 0; i < l.size(); ++i) {
        Loops others;
        for (std::size_t j = 0; j < l.size(); ++j)
            if (j != i) others.add(l[j]);
        const bool within = contains(others, l[i][0]);
        if ((signed_area(l[i]) > 0) == within) return false;
    }
    return true;
}

Loops scaled(Loops l, double by) {
    for (Vec2& p : l.points) p = by * p;
    return l;
}

} // namespace

TEST(Simple, AgreesWithAllPairsOnSmallGrids) {
    Random random{7};
    std::size_t simple = 0;
    for (int round = 0; round < 60000; ++round) {
        Loops l;
        const std::uint64_t grid = 3 + random(6);
        for (std::uint64_t loops = 1 + random(2); loops > 0; --loops) {
            for (std::uint64_t n = 3 + random(4), k = 0; k < n; ++k)
                l.points.push_back({static_cast<double>(random(grid)), static_cast<double>(random(grid))});
            l.close();
        }
        const bool expected = simple_by_pairs(l);
        simple += expected ? 1 : 0;
        ASSERT_EQ(is_simple(scaled(l, 1e-4)), expected) << "round " << round; // one unit is one step of the grid
        const bool wide = is_simple(scaled(l, 1e6));                          // 128-bit integers
        ASSERT_EQ(wide, expected) << "round " << round;
    }
    EXPECT_GT(simple, 1000U);
}

TEST(Simple, StarsWithHolesAndIslands) {
    Random random{3};
    const auto star = [&](Vec2 at, double r, bool hole) {
        std::vector<Vec2> p;
        for (int k = 0; k < 60; ++k) {
            const double a = 2 * std::numbers::pi * k / 60,
                         q = r * (0.8 + 0.2 * static_cast<double>(random(1000)) / 1000);
            p.push_back({at.x + q * std::cos(a), at.y + q * std::sin(a)});
        }
        if (hole) std::reverse(p.begin(), p.end());
        return p;
    };
    for (int round = 0; round < 50; ++round) {
        Loops l;
        l.add(star({0, 0}, 20, false));
        l.add(star({3, 3}, 9, true));
        l.add(star({4, 2}, 4, false));
        l.add(star({50, 0}, 20, false));
        EXPECT_TRUE(is_simple(l));
        Loops turned = l; // the island as a hole of the hole
        std::reverse(turned.points.begin() + 120, turned.points.begin() + 180);
        EXPECT_FALSE(is_simple(turned));
        Loops crossed = l;
        crossed.add(star({35, 0}, 9, false));
        EXPECT_FALSE(is_simple(crossed));
        EXPECT_TRUE(is_simple(unite(crossed)));
    }
    EXPECT_TRUE(is_simple(Loops{}));
}

// Rings of random depth in a grid of squares, in random order: every loop's surrounding one is known.
TEST(Simple, NestingNamesTheSmallestLoopAround) {
    Random random{11};
    for (int round = 0; round < 200; ++round) {
        std::vector<std::vector<Vec2>> loops;
        std::vector<int> around;
        for (int column = 0; column < 4; ++column)
            for (std::uint64_t depth = 0, n = 1 + random(6); depth < n; ++depth) {
                const double lo = 0.1 * static_cast<double>(depth + 1), hi = 2 - lo, x = 3 * column;
                loops.push_back({{x + lo, lo}, {x + hi, lo}, {x + hi, hi}, {x + lo, hi}});
                if (depth % 2 == 1) std::reverse(loops.back().begin(), loops.back().end());
                around.push_back(depth == 0 ? -1 : static_cast<int>(loops.size()) - 2);
            }
        std::vector<std::size_t> order(loops.size()), place(loops.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random(i)]);
        Loops all;
        for (std::size_t i = 0; i < order.size(); ++i) {
            place[order[i]] = i;
            all.add(loops[order[i]]);
        }
        const auto found = nesting(all);
        ASSERT_TRUE(found);
        for (std::size_t l = 0; l < loops.size(); ++l)
            EXPECT_EQ((*found)[place[l]],
                      around[l] < 0 ? -1 : static_cast<int>(place[static_cast<std::size_t>(around[l])]));
        const Parts parts = split(all);
        std::size_t holes = 0;
        for (std::size_t k = 0; k < parts.part.size(); ++k) {
            EXPECT_GT(signed_area(parts.part[k]), 0);
            holes += parts.part[k].size() - 1;
            if (parts.parent[k] < 0) continue;
            const auto& parent = parts.part[static_cast<std::size_t>(parts.parent[k])];
            EXPECT_FALSE(contains(parent, parts.part[k][0][0])); // it lies in the hole
        }
        EXPECT_EQ(holes + parts.part.size(), loops.size());
    }
}
