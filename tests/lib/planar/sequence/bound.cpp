#include "sequence/cover.hpp"
#include "sequence/matching.hpp"
#include "sequence/relaxation.hpp"
#include "sequence/search.hpp"
#include "worlds.hpp"

#include <gtest/gtest.h>

namespace filum::sequence {
namespace {

// An order that chooses at random among what is ready, most often going on with its stroke.
Order random_order(Random& random, const Graph& g) {
    std::vector<Index> waiting(g.size()), ready;
    for (Index v = 0; v < g.size(); ++v)
        if ((waiting[v] = static_cast<Index>(g.before[v].size())) == 0) ready.push_back(v);
    Order out;
    while (!ready.empty()) {
        std::size_t pick = random() % ready.size();
        for (std::size_t i = 0; i < ready.size(); ++i)
            if (!out.empty() && random() % 8 != 0 && continues(g, out.back(), ready[i])) pick = i;
        const Index v = ready[pick];
        ready.erase(ready.begin() + static_cast<long>(pick));
        out.push_back(v);
        for (const Index w : g.after[v])
            if (--waiting[w] == 0) ready.push_back(w);
    }
    return out;
}

TEST(CuttingPlanes, HoldForEveryOrder) {
    Random random(7);
    std::size_t cuts = 0, rivals = 0, tight = 0;
    for (int trial = 0; trial < 60; ++trial) {
        const Towers t = random_towers(random, {any(random, 3, 8), 20, 8});
        const Graph& g = t.g;
        CuttingPlanes source(g, t.columns, kAmple);
        std::vector<Inequality> all = source.degrees();
        Cover cover(g.up.size());
        cover.add(all);
        for (int round = 0; round < 20; ++round) {
            cover.solve(kAmple);
            auto unused = cover.unused();
            if (round % 3 == 2) // what nobody would propose
                for (double& x : unused) x = std::max(0.0, uniform(random, -2, 1));
            const auto more = source.violated(unused);
            all.insert(all.end(), more.begin(), more.end());
            cover.add(more);
        }
        cuts += all.size();
        for (const Inequality& x : all) rivals += x.least > 1 ? 1 : 0;
        for (int i = 0; i < 30; ++i) {
            const Order order = random_order(random, g);
            check(g, order);
            std::vector<char> used(g.up.size(), 0);
            for (std::size_t k = 1; k < order.size(); ++k) {
                const auto up = g.up[order[k - 1]];
                const auto at = std::lower_bound(up.begin(), up.end(), order[k]);
                if (at != up.end() && *at == order[k]) used[g.up.start[order[k - 1]] + (at - up.begin())] = 1;
            }
            for (const Inequality& x : all) {
                const auto left = std::count_if(x.link.begin(), x.link.end(), [&](Index a) { return used[a] == 0; });
                EXPECT_GE(left, x.least);
                tight += left == x.least ? 1 : 0;
            }
        }
    }
    EXPECT_GT(cuts, 2000);
    EXPECT_GT(rivals, 15);
    EXPECT_GT(tight, 10 * cuts);
}

TEST(Bounds, AreNoMoreThanEnumerationFinds) {
    Random random(9);
    int worlds = 0, above_cover = 0, relaxed_best = 0, slabs_above_cover = 0;
    for (int trial = 0; trial < 600; ++trial) {
        const Towers t = random_towers(random, {any(random, 2, 5), any(random, 3, 7), any(random, 1, 4)});
        if (t.g.size() > 13) continue;
        ++worlds;
        const Index least = fewest_strokes(t.g);
        const auto w = weights(t.g, t.columns, 0.02);
        const Index relaxed = Relaxation(t.g, t.columns).tighten(kNone, kAmple);
        EXPECT_LE(path_cover(t.g), relaxed) << trial;
        EXPECT_LE(relaxed, least) << trial;
        const Index in_slabs = Relaxation(t.g, t.columns, 12).tighten(kNone, kAmple);
        EXPECT_LE(in_slabs, least) << trial;
        slabs_above_cover += in_slabs > path_cover(t.g) ? 1 : 0;
        const SearchResult f = search(t.g, t.columns, w, 5000, kAmple);
        EXPECT_TRUE(f.optimal);
        check(t.g, f.order);
        EXPECT_EQ(cost(t.g, f.order).strokes, least) << trial;
        above_cover += least > path_cover(t.g) ? 1 : 0;
        relaxed_best += relaxed == least ? 1 : 0;
    }
    RecordProperty("worlds", worlds);
    RecordProperty("above_cover", above_cover);
    RecordProperty("relaxation_optimal", relaxed_best);
    EXPECT_GT(worlds, 250);
    EXPECT_GT(above_cover * 3, worlds);
    EXPECT_GT(relaxed_best * 10, worlds * 9);
    EXPECT_GT(slabs_above_cover, 100);
}

TEST(Slabs, HoldEveryLinkOnce) {
    Random random(11);
    std::size_t many = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Towers t = random_towers(random, {any(random, 1, 8), any(random, 1, 30), 4});
        const auto parts = slabs(t.g, t.columns, 1 + random() % 300);
        std::vector<Pair> links;
        for (const Slab& s : parts) {
            for (Index u = 0; u < s.g.size(); ++u) {
                for (const Index v : s.g.up[u]) links.emplace_back(s.first + u, s.first + v);
                EXPECT_EQ(s.g.node[u].z, t.g.node[s.first + u].z);
                const auto& column = s.columns.member[s.columns.of[u]];
                EXPECT_EQ(std::count(column.begin(), column.end(), u), 1);
            }
        }
        std::sort(links.begin(), links.end());
        const Arcs again = arcs(t.g.size(), links);
        EXPECT_EQ(again.to, t.g.up.to);
        EXPECT_EQ(links.size(), t.g.up.size());
        many += parts.size() > 2 ? 1 : 0;
    }
    EXPECT_GT(many, 20);
}

TEST(Cover, AnyPricesProveABound) {
    Random random(8);
    for (int trial = 0; trial < 200; ++trial) {
        const Index links = 2 + random() % 9;
        std::vector<Inequality> cuts(1 + random() % 6);
        for (Inequality& c : cuts) {
            for (Index a = 0; a < links; ++a)
                if (random() % 2 == 0) c.link.push_back(a);
            c.least = c.link.empty() ? 0 : static_cast<Index>(random() % c.link.size());
        }
        Index fewest = kNone; // by enumeration
        for (std::uint32_t set = 0; set < 1U << links; ++set)
            if (std::all_of(cuts.begin(), cuts.end(), [&](const Inequality& c) {
                    return std::count_if(c.link.begin(), c.link.end(), [&](Index a) { return set >> a & 1; }) >=
                           c.least;
                }))
                fewest = std::min(fewest, static_cast<Index>(std::popcount(set)));
        for (int i = 0; i < 20; ++i) {
            std::vector<double> prices;
            for (std::size_t k = 0; k < cuts.size(); ++k) prices.push_back(uniform(random, -0.5, 1.5));
            EXPECT_LE(proven_unused(links, cuts, prices), fewest);
        }
        Cover cover(links);
        cover.add(cuts);
        std::vector<double> sums; // with costs that differ a little, and with exact ones
        for (const bool exact : {false, true}) {
            if (exact) cover.make_exact();
            EXPECT_TRUE(cover.solve(kAmple));
            EXPECT_LE(cover.proven(), fewest);
            sums.push_back(0);
            for (const double x : cover.unused()) sums.back() += x;
            EXPECT_GE(cover.proven() + 1e-6, sums.back()); // nothing is lost by whole numbers
        }
        EXPECT_LE(sums[1], sums[0] + 1e-6);
        EXPECT_LE(sums[0], 1.02 * sums[1] + 1e-6);
    }
}

// Two towers in each other's way from `apart` layers on.
Towers twin_towers(Index layers, Index apart) {
    Towers t;
    std::vector<Pair> support;
    t.columns.member.resize(2);
    for (Index l = 0; l < layers; ++l)
        for (Index i = 0; i < 2; ++i) {
            const Index v = 2 * l + i;
            t.g.node.push_back({l, 0.2 * l, {10.0 * i, 0}});
            t.columns.member[i].push_back(v);
            t.columns.of.push_back(i);
            if (l > 0) support.emplace_back(v - 2, v);
            if (l >= apart) t.collisions.emplace_back(2 * (l - apart) + 1 - i, v);
        }
    t.g.up = arcs(t.g.size(), support);
    t.g.down = reversed(t.g.up);
    t.g.after = t.g.up;
    t.g.before = t.g.down;
    add_precedence(t.g, t.collisions);
    return t;
}

// The bound on towers of thinner and thinner layers is the same, and its cuts and pivots hardly become more.
TEST(Relaxation, TakesAsManyPivotsOnTallTowers) {
    for (const Index parts : {4U, 10U}) {
        double work[2];
        Index bound[2];
        for (const Index k : {0U, 1U}) {
            const Index layers = k == 0 ? 160 : 640;
            const Towers t = twin_towers(layers, layers / parts);
            Relaxation r(t.g, t.columns);
            bound[k] = r.tighten(kNone, 10 * kAmple);
            work[k] = static_cast<double>(r.work()) / layers;
        }
        EXPECT_EQ(bound[0], bound[1]) << parts;
        EXPECT_LT(work[1], 2 * work[0]) << parts;
    }
}

} // namespace
} // namespace filum::sequence
