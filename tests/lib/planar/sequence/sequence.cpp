#include "../../trials.hpp"
#include "base/error.hpp"
#include "sequence/canon.hpp"
#include "sequence/climb.hpp"
#include "sequence/matching.hpp"
#include "sequence/relaxation.hpp"
#include "sequence/search.hpp"
#include "worlds.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace filum::sequence {
namespace {

Index relaxed(const Graph& g, const Columns& c) { return Relaxation(g, c).tighten(kNone, kAmple); }

TEST(Matching, IsMaximumOnSmallGraphs) {
    Random random(1);
    for (int trial = 0; trial < 300; ++trial) {
        const Index n = 3 + random() % 6;
        std::vector<Pair> pairs;
        for (Index u = 0; u < n; ++u)
            for (Index v = u + 1; v < n; ++v)
                if (random() % 3 == 0) pairs.emplace_back(u, v);
        const Arcs links = arcs(n, pairs);
        const auto next = maximum_matching(links);
        std::vector<int> entered(n, 0);
        for (Index u = 0; u < n; ++u)
            if (next[u] != kNone) {
                EXPECT_TRUE(std::binary_search(links[u].begin(), links[u].end(), next[u]));
                EXPECT_EQ(++entered[next[u]], 1);
            }
        std::vector<Index> most(std::size_t{1} << n, 0); // by the set of entered nodes, u by u
        for (Index u = 0; u < n; ++u)
            for (std::size_t set = most.size(); set-- > 0;)
                for (const Index v : links[u])
                    if ((set >> v & 1) == 0) {
                        auto& to = most[set | std::size_t{1} << v];
                        if (static_cast<Index>(std::popcount(set)) == most[set]) to = std::max(to, most[set] + 1);
                    }
        EXPECT_EQ(matched(next), *std::max_element(most.begin(), most.end()));
    }
}

// Exact optima of k columns.
TEST(Search, FindsTheKnownOptimaOfEqualTowers) {
    struct Row {
        Index k, layers, c, optimum;
    };
    for (const Row r : {Row{2, 8, 1, 9},
                        {2, 8, 2, 5},
                        {2, 8, 4, 3},
                        {2, 10, 5, 3},
                        {3, 5, 1, 11},
                        {3, 6, 2, 7},
                        {3, 6, 3, 5},
                        {4, 4, 1, 13}}) {
        const Towers t = towers(r.k, r.layers, r.c);
        const auto w = weights(t.g, t.columns, 0.02);
        const SearchResult f = search(t.g, t.columns, w, 1000, kAmple);
        EXPECT_TRUE(f.optimal);
        check(t.g, f.order);
        EXPECT_EQ(cost(t.g, f.order).strokes, r.optimum) << r.k << "x" << r.layers << " c " << r.c;
        EXPECT_EQ(relaxed(t.g, t.columns), r.optimum) << r.k << "x" << r.layers << " c " << r.c;
        EXPECT_EQ(cost(t.g, layer_order(t.g)).strokes, r.k * r.layers - r.layers + 1);
        EXPECT_EQ(path_cover(t.g), r.k);
    }
}

TEST(Search, LargeTowersMeetTheirBound) { // (k - 1) ceil(n / c) + 1
    for (const Index c : {3U, 7U, 20U}) {
        const Towers t = towers(5, 60, c);
        const auto w = weights(t.g, t.columns, 0.02);
        const Index bound = relaxed(t.g, t.columns);
        EXPECT_EQ(bound, 4 * ((60 + c - 1) / c) + 1);
        EXPECT_EQ(cost(t.g, search(t.g, t.columns, w, 64, kAmple).order).strokes, bound) << c;
    }
}

TEST(Search, AgreesWithEnumerationOnRandomWorlds) {
    Random random(3);
    int worlds = 0, greedy_best = 0, search_best = 0, relaxed_best = 0, above_cover = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const auto high = static_cast<std::uint32_t>(2 + random() % 4);
        const auto most = static_cast<int>(2 + random() % 3);
        const auto regions = random_world(random, high, most, uniform(random, 2, 8));
        if (regions.size() > 13) continue;
        ++worlds;
        Graph g = support_graph(regions);
        const Columns c = columns(g, colours(g));
        machine::Head head;
        head.flat_radius = uniform(random, 0, 2);
        head.none = random() % 4 == 0;
        std::vector<Outline> outlines;
        for (const auto& r : regions) outlines.push_back(outline(r.loops));
        const auto hits = collisions(g, c, outlines, head);
        add_precedence(g, hits);
        const Index least = fewest_strokes(g);
        const auto w = weights(g, c, 0.02);

        const SearchResult wide = search(g, c, w, 5000, kAmple);
        ASSERT_TRUE(wide.optimal);
        check(g, wide.order);
        EXPECT_EQ(cost(g, wide.order).strokes, least) << trial;
        EXPECT_LE(path_cover(g), least);
        EXPECT_LE(relaxed(g, c), least) << trial;
        above_cover += least > path_cover(g) ? 1 : 0;
        relaxed_best += relaxed(g, c) == least ? 1 : 0;

        const SearchResult alike = search(g, c, w, 5000, kAmple, 0); // every state has the same hash
        EXPECT_TRUE(alike.optimal);
        EXPECT_EQ(alike.order, wide.order) << trial;

        const SearchResult narrow = search(g, c, w, 1, kAmple);
        check(g, narrow.order);
        EXPECT_GE(cost(g, narrow.order).strokes, least);
        search_best += cost(g, narrow.order).strokes == least ? 1 : 0;
        Index greedy = kNone;
        for (const StartRule rule : {StartRule::longest, StartRule::lowest, StartRule::latest}) {
            const Order o = climb(g, rule);
            check(g, o);
            EXPECT_GE(cost(g, o).strokes, least);
            greedy = std::min(greedy, cost(g, o).strokes);
        }
        greedy_best += greedy == least ? 1 : 0;
        const Order layers = layer_order(g);
        check(g, layers);
        EXPECT_GE(cost(g, layers).strokes, least);
    }
    EXPECT_GT(worlds, 250);
    EXPECT_GT(above_cover, 50); // the head matters in these worlds
    RecordProperty("worlds", worlds);
    RecordProperty("greedy_optimal", greedy_best);
    RecordProperty("narrow_search_optimal", search_best);
    RecordProperty("relaxation_optimal", relaxed_best);
    EXPECT_GT(relaxed_best * 10, worlds * 9);
    EXPECT_GT(greedy_best * 10, worlds * 8);
    EXPECT_GT(search_best * 10, worlds * 8);
}

// What collisions() leaves out must be implied: no order it allows may bring the head to an upper region.
TEST(Collisions, KeepTheHeadClearInEveryPairOfRegions) {
    Random random(4);
    std::size_t kept = 0, plain = 0;
    for (int trial = 0; trial < 40; ++trial) {
        const auto regions = random_world(random, 12, 4, uniform(random, 4, 40));
        machine::Head head;
        head.flat_radius = uniform(random, 0.1, 1);
        head.cone_angle = uniform(random, 0.5, 2.5);
        head.cone_height = uniform(random, 0.3, 3);
        head.carriage_x = uniform(random, 2, 30);
        head.carriage_y = uniform(random, 2, 30);
        if (trial % 5 == 0) head.gantry_height = 1.5;
        Graph g = support_graph(regions);
        std::vector<Outline> outlines;
        for (const auto& r : regions) outlines.push_back(outline(r.loops));
        const auto hits = collisions(g, columns(g, colours(g)), outlines, head);
        kept += hits.size();
        add_precedence(g, hits);
        // reach[v] holds u if v comes before u in every order
        const Index n = g.size();
        std::vector<std::vector<char>> reach(n, std::vector<char>(n, 0));
        for (Index v = n; v-- > 0;)
            for (const Index u : g.after[v]) {
                reach[v][u] = 1;
                for (Index x = 0; x < n; ++x) reach[v][x] = static_cast<char>(reach[v][x] | reach[u][x]);
            }
        for (Index v = 0; v < n; ++v)
            for (Index u = v + 1; u < n; ++u)
                if (plainly_collides(regions[v], regions[u], head)) {
                    ++plain;
                    EXPECT_TRUE(reach[v][u]) << trial << ": " << v << " under " << u;
                }
        for (const auto& [v, u] : hits) { // and none that is no collision
            machine::Head larger = head;
            larger.flat_radius += 1e-3;
            larger.carriage_x += 0.1;
            larger.carriage_y += 0.1;
            EXPECT_TRUE(plainly_collides(regions[v], regions[u], larger)) << trial;
        }
    }
    EXPECT_GT(plain, 4 * kept);
}

TEST(Sequence, IsFeasibleAndNeverWorseThanByLayers) {
    Random random(5);
    for (int trial = 0; trial < trials(30); ++trial) {
        const auto regions = random_world(random, 20, 6, uniform(random, 5, 60));
        Options o;
        o.budget = 1'000'000;
        const SequenceResult r = sequence(regions, o);
        ASSERT_EQ(r.order.size(), regions.size());
        std::vector<Index> place(regions.size(), kNone);
        for (Index i = 0; i < r.order.size(); ++i) place[r.order[i]] = i;
        for (std::size_t v = 0; v < regions.size(); ++v) {
            ASSERT_NE(place[v], kNone);
            for (const auto& b : regions[v].below) EXPECT_LT(place[b.below], place[v]);
            for (std::size_t u = v + 1; u < regions.size(); ++u)
                EXPECT_TRUE(place[v] < place[u] || !plainly_collides(regions[v], regions[u], o.heads.common));
        }
        std::uint32_t strokes = 0;
        for (std::size_t i = 0; i < r.order.size(); ++i) {
            const auto& below = regions[r.order[i]].below;
            const bool linked = i > 0 && std::any_of(below.begin(), below.end(), [&](const auto& b) {
                                    return b.below == r.order[i - 1] && b.link;
                                });
            if (r.join[i] == Join::start)
                ++strokes;
            else
                EXPECT_TRUE(linked);
            EXPECT_EQ(r.stroke[i] + 1, strokes);
        }
        EXPECT_EQ(fact(r, "planned-strokes"), strokes);
        EXPECT_LE(fact(r, "lower-bound"), strokes);
        EXPECT_GE(fact(r, "lower-bound"), fact(r, "path-cover"));
        Options layers = o;
        layers.by_layers = true;
        const SequenceResult l = sequence(regions, layers);
        EXPECT_LE(strokes, fact(l, "planned-strokes"));
        EXPECT_GE(fact(l, "planned-strokes"), fact(l, "layer-floor"));
        for (std::size_t i = 1; i < l.order.size(); ++i)
            EXPECT_LE(regions[l.order[i - 1]].layer, regions[l.order[i]].layer);
    }
}

TEST(LayerOrder, UsesAsManyLinksAsAnyLayerOrder) {
    Random random(6);
    for (int trial = 0; trial < 100; ++trial) {
        const auto regions = random_world(random, 4, 3, 4);
        const Graph g = support_graph(regions);
        // all of a layer before all of the next: enumerate by precedence
        Graph strict = g;
        std::vector<Pair> more;
        for (Index u = 0; u < g.size(); ++u)
            for (Index v = 0; v < g.size(); ++v)
                if (g.node[u].layer < g.node[v].layer) more.emplace_back(u, v);
        add_precedence(strict, more);
        EXPECT_EQ(cost(g, layer_order(g)).strokes, fewest_strokes(strict)) << trial;
    }
}

TEST(Sequence, OneColumnIsOneStroke) {
    std::vector<Outlined> tower;
    for (std::uint32_t l = 0; l < 300; ++l) tower.push_back({l, box(0, 0, 5, 5)});
    const SequenceResult r = sequence(world(tower), {});
    EXPECT_EQ(fact(r, "planned-strokes"), 1);
    EXPECT_EQ(fact(r, "lower-bound"), 1);
}

TEST(Sequence, FarApartTowersAreClimbedWholeAndNearOnesInTurns) {
    const auto pair = [](double gap) {
        std::vector<Outlined> two;
        for (std::uint32_t l = 0; l < 100; ++l) {
            two.push_back({l, box(0, 0, 5, 5)});
            two.push_back({l, box(5 + gap, 0, 5, 5)});
        }
        return sequence(world(two), {});
    };
    EXPECT_EQ(fact(pair(21), "planned-strokes"), 2);
    // from 8 mm, 40 layers, the carriage is in the way: clearance 41 layers, ceil(100 / 41) + 1
    EXPECT_EQ(fact(pair(10), "planned-strokes"), 4);
    // 1 mm apart: the cone is 1 mm wide at (1 - 0.2) / tan 30 = 1.386 mm: clearance 7 layers
    EXPECT_EQ(fact(pair(1), "planned-strokes"), 16);
    EXPECT_EQ(fact(pair(1), "lower-bound"), 16);
}

TEST(Sequence, MeetsItsBoundWithoutAHead) {
    Random random(12);
    int above_cover = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const auto regions = random_world(random, 30, 6, uniform(random, 2, 20));
        Options o;
        o.heads.common.none = true;
        const SequenceResult r = sequence(regions, o);
        EXPECT_EQ(fact(r, "planned-strokes"), fact(r, "lower-bound")) << trial;
        above_cover += fact(r, "planned-strokes") > fact(r, "path-cover") ? 1 : 0;
    }
    RecordProperty("above_cover", above_cover);
}

TEST(Sequence, RefusesWhatRegionsWouldNotWrite) {
    auto regions = world({{0, box(0, 0, 1, 1)}, {1, box(0, 0, 1, 1)}});
    const auto rejects = [](std::vector<polygon::Region> r) {
        try {
            sequence(std::move(r), {});
        } catch (const Error& e) {
            return e.exit() == Exit::bad_input;
        }
        return false;
    };
    EXPECT_FALSE(rejects(regions));
    auto broken = regions;
    broken[1].id = 5;
    EXPECT_TRUE(rejects(broken));
    broken = regions;
    broken[1].below[0].below = 1;
    EXPECT_TRUE(rejects(broken));
    broken = regions;
    std::swap(broken[0], broken[1]);
    EXPECT_TRUE(rejects(broken));
    broken = regions;
    broken[1].z = 0.2;
    EXPECT_TRUE(rejects(broken));
    EXPECT_TRUE(sequence({}, {}).order.empty());
}

TEST(Check, CatchesWrongOrders) {
    const Towers t = towers(2, 3, 1);
    const auto wrong = [&](Order o) {
        try {
            check(t.g, o);
        } catch (const Error&) {
            return true;
        }
        return false;
    };
    EXPECT_FALSE(wrong({0, 1, 2, 3, 4, 5}));
    EXPECT_TRUE(wrong({0, 1, 2, 3, 4}));
    EXPECT_TRUE(wrong({0, 1, 2, 3, 4, 4}));
    EXPECT_TRUE(wrong({0, 2, 1, 3, 4, 5})); // 2 waits for 1
}

} // namespace
} // namespace filum::sequence
