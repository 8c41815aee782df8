// What the job itself decides is decided alike, whichever way its regions are numbered and wherever they lie.
#include "sequence/canon.hpp"
#include "sequence/arrange.hpp"
#include "sequence/plan.hpp"
#include "worlds.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace filum::sequence {
namespace {

// New numbers for the nodes, at random within each layer: node v becomes to[v].
std::vector<Index> renumbered(Random& random, const Graph& g) {
    std::vector<Index> to(g.size());
    for (Index v = 0; v < g.size();) {
        Index end = v;
        while (end < g.size() && g.node[end].layer == g.node[v].layer) ++end;
        std::iota(to.begin() + v, to.begin() + end, v);
        std::shuffle(to.begin() + v, to.begin() + end, random);
        v = end;
    }
    return to;
}

Arcs renumbered(const Arcs& a, const std::vector<Index>& to) {
    std::vector<Pair> pairs;
    for (Index u = 0; u < to.size(); ++u)
        for (const Index v : a[u]) pairs.emplace_back(to[u], to[v]);
    return arcs(to.size(), std::move(pairs));
}

Towers renumbered(const Towers& t, const std::vector<Index>& to) {
    Towers out = t;
    for (Index v = 0; v < to.size(); ++v) {
        out.g.node[to[v]] = t.g.node[v];
        out.columns.of[to[v]] = t.columns.of[v];
    }
    for (auto& member : out.columns.member)
        for (Index& v : member) v = to[v];
    out.g.up = renumbered(t.g.up, to);
    out.g.down = reversed(out.g.up);
    out.g.after = renumbered(t.g.after, to);
    out.g.before = reversed(out.g.after);
    return out;
}

TEST(Canon, NumbersDoNotDecide) {
    Random random(21);
    std::size_t many = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Towers t = random_towers(random, {any(random, 2, 9), any(random, 6, 25), 5});
        const auto to = renumbered(random, t.g);
        const Towers r = renumbered(t, to);
        const auto c = colours(t.g), d = colours(r.g);
        for (Index v = 0; v < t.g.size(); ++v) EXPECT_EQ(c[v], d[to[v]]);
        const Columns a = columns(t.g, c), b = columns(r.g, d);
        EXPECT_EQ(a.member.size(), b.member.size());
        const Plan p = plan(t.g, t.columns, 200'000), q = plan(r.g, r.columns, 200'000);
        check(t.g, p.order);
        check(r.g, q.order);
        EXPECT_EQ(p.cost.strokes, q.cost.strokes) << trial;
        EXPECT_EQ(p.bound, q.bound) << trial;
        many += p.cost.strokes > p.path_cover ? 1 : 0;
    }
    EXPECT_GT(many, 20U);
}

TEST(Canon, PartsHoldAllOnce) {
    Random random(22);
    for (int trial = 0; trial < 50; ++trial) {
        const auto regions = random_world(random, 5, 4, 12);
        Graph g = support_graph(regions);
        const Columns c = columns(g, colours(g));
        std::vector<int> seen(g.size(), 0);
        std::size_t arcs = 0, links = 0;
        for (const Part& p : parts(g, c)) {
            for (Index i = 0; i < p.node.size(); ++i) {
                ++seen[p.node[i]];
                EXPECT_EQ(p.g.node[i].z, g.node[p.node[i]].z);
                for (const Index j : p.g.up[i]) EXPECT_TRUE(continues(g, p.node[i], p.node[j]));
                const auto& member = p.columns.member[p.columns.of[i]];
                EXPECT_EQ(std::count(member.begin(), member.end(), i), 1);
            }
            arcs += p.g.after.size();
            links += p.g.up.size();
        }
        EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), static_cast<long>(g.size()));
        EXPECT_EQ(arcs, g.after.size());
        EXPECT_EQ(links, g.up.size());
    }
}

TEST(Arranged, KeepsStrokesAndOrderAndTravelsLess) {
    Random random(23);
    int better = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const Towers t = random_towers(random, {any(random, 2, 9), 10, 6});
        const Order order = layer_order(t.g), now = arranged(t.g, order);
        check(t.g, now);
        EXPECT_LE(cost(t.g, now), cost(t.g, order));
        better += cost(t.g, now) < cost(t.g, order) ? 1 : 0;
    }
    EXPECT_GT(better, 10);
}

// The same job mirrored, turned by a right angle and shifted: the same strokes under the same head.
TEST(Sequence, PlacesDoNotDecide) {
    Random random(24);
    for (int trial = 0; trial < 60; ++trial) {
        const auto regions = random_world(random, 8, 4, 14);
        Options options;
        options.budget = 1'000'000;
        options.heads.common.carriage_x = options.heads.common.carriage_y = 8;
        options.heads.common.cone_height = 0.5;
        const auto strokes = [&](const auto& place, bool mirrored) {
            auto now = regions;
            for (auto& r : now) {
                for (auto& p : r.loops.points) p = place(p);
                for (std::size_t l = 0; mirrored && l < r.loops.size(); ++l)
                    std::reverse(r.loops.points.begin() + static_cast<long>(r.loops.start[l]),
                                 r.loops.points.begin() + static_cast<long>(r.loops.start[l + 1]));
                r.box = polygon::bounds(r.loops);
            }
            const SequenceResult out = sequence(now, options);
            return out.stroke.back();
        };
        using geom::Vec2;
        const auto as_is = strokes([](Vec2 p) { return p; }, false);
        EXPECT_EQ(as_is, strokes([](Vec2 p) { return Vec2{-p.x, p.y}; }, true)) << trial;
        EXPECT_EQ(as_is, strokes([](Vec2 p) { return Vec2{-p.y, p.x}; }, false)) << trial;
        EXPECT_EQ(as_is, strokes([](Vec2 p) { return Vec2{p.x + 128, p.y - 64}; }, false)) << trial;
    }
}

} // namespace
} // namespace filum::sequence
