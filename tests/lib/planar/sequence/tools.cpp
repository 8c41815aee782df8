#include "../../trials.hpp"
#include "sequence/arrange.hpp"
#include "sequence/canon.hpp"
#include "sequence/phases.hpp"
#include "sequence/plan.hpp"
#include "worlds.hpp"

#include <gtest/gtest.h>

#include <map>

namespace filum::sequence {
namespace {

constexpr Index kMostRegions = 11; // that enumeration takes

// Regions of a random world with random tools; regions of different tools have no links.
std::vector<polygon::Region> tool_world(Random& random, Index tools) {
    std::vector<polygon::Region> out;
    do {
        const auto layers = static_cast<std::uint32_t>(any(random, 2, 4));
        out = random_world(random, layers, static_cast<int>(any(random, 2, 3)), uniform(random, 2, 6));
    } while (out.size() > kMostRegions);
    for (auto& r : out) {
        r.tool = any(random, 0, tools - 1);
        for (auto& o : r.below) o.link = o.link && out[o.below].tool == r.tool;
    }
    return out;
}

struct World {
    Graph g;
    Columns columns;
    std::vector<Outline> outlines;
};

World prepared(const std::vector<polygon::Region>& regions, const machine::Heads& heads) {
    World w{support_graph(regions), {}, {}};
    w.columns = columns(w.g, colours(w.g));
    for (const auto& r : regions) w.outlines.push_back(outline(r.loops));
    add_precedence(w.g, collisions(w.g, w.columns, w.outlines, heads));
    return w;
}

// The least cost of all orders, by enumeration of the sets of printed regions.
Cost least_cost(const Graph& g, Priority first) {
    const std::size_t sets = std::size_t{1} << g.size();
    std::vector<std::map<Index, Cost>> best(sets); // per set, by the last region
    const auto offer = [&](std::size_t set, Index last, const Cost& c) {
        const auto [at, fresh] = best[set].try_emplace(last, c);
        if (!fresh && less(c, at->second, first)) at->second = c;
    };
    const auto ready = [&](std::size_t set, Index v) {
        return (set >> v & 1) == 0 &&
               std::all_of(g.before[v].begin(), g.before[v].end(), [&](Index p) { return (set >> p & 1) != 0; });
    };
    for (Index v = 0; v < g.size(); ++v)
        if (ready(0, v)) offer(std::size_t{1} << v, v, {1, 0, 0});
    for (std::size_t set = 1; set + 1 < sets; ++set)
        for (const auto& [last, c] : best[set])
            for (Index v = 0; v < g.size(); ++v) {
                if (!ready(set, v)) continue;
                Cost next = c;
                if (g.node[last].tool != g.node[v].tool) ++next.changes;
                if (!continues(g, last, v)) ++next.strokes;
                offer(set | std::size_t{1} << v, v, next);
            }
    Cost out{kNone, kNone, 0};
    for (const auto& [last, c] : best[sets - 1])
        if (less(c, out, first)) out = c;
    return out;
}

machine::Heads random_heads(Random& random, Index tools, bool mounted) {
    machine::Heads out;
    out.common.flat_radius = uniform(random, 0, 1);
    for (Index t = 1; t < tools; ++t) {
        out.own[t] = out.common;
        out.own[t].flat_radius = uniform(random, 0, 2);
        if (mounted) out.mount[t] = {uniform(random, -4, 4), uniform(random, -4, 4), 0};
    }
    if (mounted) {
        out.mount[0] = {};
        out.raised = random() % 2 == 0 ? 0 : 0.3;
    }
    return out;
}

TEST(Tools, PlansAgreeWithEnumeration) {
    Random random(5);
    int strokes_first = 0, changes_first = 0, worlds = 0;
    for (int trial = 0; trial < trials(250); ++trial) {
        const Index tools = any(random, 2, 3);
        const auto regions = tool_world(random, tools);
        const World w = prepared(regions, random_heads(random, tools, random() % 2 == 0));
        if (sequence::tools(w.g).size() < 2) continue;
        ++worlds;
        const Cost least = least_cost(w.g, Priority::strokes), fewest = least_cost(w.g, Priority::tool_changes);
        EXPECT_LE(least_changes(w.g), fewest.changes) << trial;
        if (tools == 2) {
            EXPECT_EQ(least_changes(w.g), fewest.changes) << trial;
        }

        const Plan p = plan(w.g, w.columns, kAmple);
        check(w.g, p.order);
        EXPECT_LE(p.bound, least.strokes);
        EXPECT_EQ(p.cost.strokes, least.strokes) << trial;
        EXPECT_GE(p.cost.changes, least.changes) << trial;
        strokes_first += p.cost.changes == least.changes ? 1 : 0;

        const Plan q = plan(w.g, w.columns, kAmple, Priority::tool_changes);
        check(w.g, q.order);
        EXPECT_EQ(q.bound, p.bound);
        EXPECT_FALSE(less(q.cost, fewest, Priority::tool_changes)) << trial;
        if (tools == 2) {
            EXPECT_EQ(q.cost.changes, fewest.changes) << trial;
        }
        changes_first += !less(fewest, q.cost, Priority::tool_changes) ? 1 : 0;
    }
    EXPECT_GT(worlds, trials(180));
    RecordProperty("worlds", worlds);
    RecordProperty("changes_optimal", strokes_first);
    RecordProperty("changes_first_optimal", changes_first);
    EXPECT_GE(strokes_first * 100, worlds * 95); // parts that are planned by themselves may begin with other tools
    EXPECT_GE(changes_first * 100, worlds * 85);
}

TEST(Tools, OneConnectedPartIsOptimal) {
    Random random(11);
    int worlds = 0;
    for (int trial = 0; trial < trials(250); ++trial) {
        const auto regions = tool_world(random, 2);
        const World w = prepared(regions, random_heads(random, 2, false));
        if (parts(w.g, w.columns).size() != 1 || tools(w.g).size() != 2) continue;
        ++worlds;
        const Cost least = least_cost(w.g, Priority::strokes), found = plan(w.g, w.columns, kAmple).cost;
        EXPECT_EQ(found.strokes, least.strokes) << trial;
        EXPECT_EQ(found.changes, least.changes) << trial;
    }
    EXPECT_GT(worlds, trials(40));
}

// Whether one of the heads that hang beside v's tool, or that itself, touches u while v is printed.
bool touches(const World& w, const machine::Heads& heads, Index v, Index u) {
    const Index tool = w.g.node[v].tool;
    const double dz = w.g.node[u].z - w.g.node[v].z;
    if (within(w.outlines[v], w.outlines[u], reach(heads.of(tool), dz))) return true;
    const auto beside = heads.beside(tool);
    return std::any_of(beside.begin(), beside.end(), [&](const machine::Heads::Idle& idle) {
        return dz > idle.shift.z && within(shifted(w.outlines[v], idle.shift.xy()), w.outlines[u],
                                           reach(heads.of(idle.tool), dz - idle.shift.z));
    });
}

TEST(Tools, NoHeadMeetsWhatStands) {
    Random random(23);
    int pairs = 0, by_idle = 0;
    for (int trial = 0; trial < trials(150); ++trial) {
        const auto regions = tool_world(random, 2);
        const machine::Heads heads = random_heads(random, 2, true);
        const World w = prepared(regions, heads);
        if (tools(w.g).size() < 2) continue;
        for (const Priority first : {Priority::strokes, Priority::tool_changes}) {
            const Plan p = plan(w.g, w.columns, kAmple, first);
            std::vector<Index> place(w.g.size());
            for (Index i = 0; i < p.order.size(); ++i) place[p.order[i]] = i;
            for (Index v = 0; v < w.g.size(); ++v)
                for (Index u = 0; u < w.g.size(); ++u) {
                    if (w.g.node[u].z <= w.g.node[v].z) continue;
                    const bool hit = touches(w, heads, v, u);
                    EXPECT_FALSE(place[u] < place[v] && hit) << trial;
                    machine::Heads own = heads;
                    own.mount.clear();
                    pairs += hit ? 1 : 0;
                    by_idle += hit && !touches(w, own, v, u) ? 1 : 0;
                }
        }
    }
    EXPECT_GT(pairs, trials(500));
    EXPECT_GT(by_idle, trials(50));
}

TEST(Tools, SpiralOfTwoInksTakesTurns) {
    std::vector<Outlined> outlined;
    for (std::uint32_t l = 0; l < 40; ++l) {
        outlined.push_back({l, box(0, 0, 2, 2)});
        outlined.push_back({l, box(2, 0, 2, 2)});
    }
    auto regions = world(outlined);
    for (auto& r : regions) {
        r.tool = r.id % 2;
        std::erase_if(r.below, [&](const auto& o) { return o.below % 2 != r.tool; });
    }
    const SequenceResult r = sequence(regions, {});
    EXPECT_EQ(fact(r, "planned-strokes"), 41);
    EXPECT_EQ(fact(r, "lower-bound"), 41);
    EXPECT_EQ(fact(r, "tool-changes"), 40);
    EXPECT_EQ(fact(r, "tool-changes-bound"), 40);
    for (auto& one : regions) one.tool = 0;
    EXPECT_EQ(fact(sequence(regions, {}), "tool-changes"), -1); // jobs with one tool have no such fact
}

TEST(Tools, ALowIdleTipIsRefused) {
    auto regions = world({{0, box(0, 0, 1, 1)}, {0, box(5, 0, 1, 1)}, {1, box(0, 0, 1, 1)}});
    regions[1].tool = 1;
    Options o;
    o.heads.mount = {{0, {}}, {1, {20, 0, 0.2}}}; // tool 0 hangs lower while tool 1 prints
    EXPECT_THROW(sequence(regions, o), Error);
    o.heads.raised = 1;
    EXPECT_EQ(fact(sequence(regions, o), "tool-changes"), 1);
}

} // namespace
} // namespace filum::sequence
