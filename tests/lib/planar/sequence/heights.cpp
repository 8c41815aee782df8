// Tools whose layers are several layers high, and shells from the inside.
#include "../../trials.hpp"
#include "sequence/arrange.hpp"
#include "worlds.hpp"

#include <gtest/gtest.h>

namespace filum::sequence {
namespace {

using polygon::Region;

// Boxes beside and on each other. Each tool has one height of its layers, from 1 to 3 layers of the job.
std::vector<Region> high_world(Random& random) {
    struct Cell {
        polygon::Loops loops;
        Index tool = 0;
    };
    const Index tools = any(random, 2, 3), layers = any(random, 4, 9);
    std::vector<Index> height;
    for (Index t = 0; t < tools; ++t) height.push_back(t == 0 ? 1 : any(random, 1, 3));
    std::vector<Region> all;
    for (Index c = 0, columns = any(random, 2, 4); c < columns; ++c) {
        const auto loops = box(uniform(random, 0, 6), 4.0 * c, uniform(random, 1, 3), uniform(random, 2, 4));
        for (Index from = 0; from < layers;) { // tools take turns in a column
            const Index tool = any(random, 0, tools - 1), n = height[tool];
            for (Index i = 0, turns = any(random, 1, 4); i < turns && from < layers; ++i) {
                Region r;
                r.layers = std::min(n, layers - from);
                r.layer = from + r.layers - 1;
                r.z = 0.2 * (r.layer + 1);
                r.height = 0.2 * r.layers;
                r.tool = tool;
                r.body = c; // so far the number of its column
                r.loops = loops;
                r.area = polygon::signed_area(loops);
                r.box = polygon::bounds(loops);
                all.push_back(r);
                from += r.layers;
            }
        }
    }
    std::stable_sort(all.begin(), all.end(), [](const Region& a, const Region& b) { return a.layer < b.layer; });
    for (Index i = 0; i < all.size(); ++i) {
        all[i].id = i;
        for (Index k = 0; k < i; ++k)
            if (all[k].body == all[i].body && all[k].layer == all[i].rests_on())
                all[i].below.push_back({k, all[i].area, 0.2, all[k].tool == all[i].tool});
    }
    return all;
}

// Whether a point of one box is nearer to one of the other than `reach`.
bool near(const Region& a, const Region& b, double reach) { return geom::distance(a.box, b.box) < reach; }

TEST(Heights, EveryRegionLiesOnWhatIsPrintedAndNoneStandsInTheWay) {
    Random random(3);
    for (int trial = 0; trial < trials(200); ++trial) {
        const auto regions = high_world(random);
        Options o;
        o.heads.common.flat_radius = uniform(random, 0, 2);
        o.heads.common.cone_height = 100;
        o.heads.common.carriage_x = o.heads.common.carriage_y = 0;
        const SequenceResult got = sequence(regions, o);
        ASSERT_EQ(got.order.size(), regions.size());
        std::vector<std::size_t> place(regions.size());
        for (std::size_t i = 0; i < got.order.size(); ++i) place[got.order[i]] = i;
        std::size_t strokes = 1;
        for (std::size_t i = 0; i < regions.size(); ++i) {
            const Region& v = regions[i];
            for (const auto& below : v.below) EXPECT_LT(place[below.below], place[i]) << trial;
            for (std::size_t k = 0; k < regions.size(); ++k) // the tip alone, which is enough for a wrong order
                if (regions[k].z > v.z + 1e-9 && near(regions[k], v, o.heads.common.flat_radius)) {
                    EXPECT_GT(place[k], place[i]) << trial << ": " << k << " stands in the way of " << i;
                }
            if (i == 0) continue;
            const Region &now = regions[got.order[i]], &before = regions[got.order[i - 1]];
            const bool climbs = now.body == before.body && now.tool == before.tool && now.rests_on() == before.layer;
            strokes += climbs ? 0 : 1;
        }
        EXPECT_EQ(static_cast<double>(strokes), fact(got, "planned-strokes")) << trial;
        EXPECT_GE(fact(got, "planned-strokes"), fact(got, "lower-bound")) << trial;
        Options layers = o;
        layers.by_layers = true;
        EXPECT_LE(fact(got, "lower-bound"), fact(sequence(regions, layers), "planned-strokes")) << trial;
    }
}

// The least strokes of all orders, by enumeration of the sets of printed regions.
Index least_strokes(const Graph& g) {
    std::vector<std::vector<Index>> best(std::size_t{1} << g.size(), std::vector<Index>(g.size(), kNone));
    const auto ready = [&](std::size_t set, Index v) {
        return (set >> v & 1) == 0 &&
               std::all_of(g.before[v].begin(), g.before[v].end(), [&](Index p) { return (set >> p & 1) != 0; });
    };
    for (Index v = 0; v < g.size(); ++v)
        if (ready(0, v)) best[std::size_t{1} << v][v] = 1;
    for (std::size_t set = 1; set + 1 < best.size(); ++set)
        for (Index last = 0; last < g.size(); ++last) {
            if (best[set][last] == kNone) continue;
            for (Index v = 0; v < g.size(); ++v) {
                if (!ready(set, v)) continue;
                Index& to = best[set | std::size_t{1} << v][v];
                to = std::min(to, best[set][last] + (continues(g, last, v) ? 0 : 1));
            }
        }
    return *std::min_element(best.back().begin(), best.back().end());
}

TEST(Heights, PlansAgreeWithEnumeration) {
    Random random(17);
    int worlds = 0;
    for (int trial = 0; trial < trials(150); ++trial) {
        const auto regions = high_world(random);
        if (regions.size() > 12) continue;
        ++worlds;
        Options o;
        o.heads.common.flat_radius = uniform(random, 0, 2);
        const SequenceResult got = sequence(regions, o);
        const Index least = least_strokes(got.graph);
        EXPECT_LE(fact(got, "lower-bound"), least) << trial;
        EXPECT_EQ(fact(got, "planned-strokes"), least) << trial;
    }
    EXPECT_GT(worlds, trials(40));
}

// Nested square shells, each with a hole for the next ones.
std::vector<Region> shells(std::uint32_t layers, int count, double gap) {
    std::vector<Region> out;
    for (std::uint32_t l = 0; l < layers; ++l)
        for (int k = 0; k < count; ++k) {
            const double outer = 2 + 2 * (count - 1 - k) * (1 + gap), wall = 1; // the outermost first
            Region r;
            r.id = static_cast<std::uint32_t>(out.size());
            r.layer = l;
            r.z = 0.2 * (l + 1);
            r.height = 0.2;
            r.loops = box(-outer / 2, -outer / 2, outer, outer);
            if (k + 1 < count) {
                const double inner = outer - 2 * wall;
                r.loops.add(std::vector<geom::Vec2>{{-inner / 2, -inner / 2},
                                                    {-inner / 2, inner / 2},
                                                    {inner / 2, inner / 2},
                                                    {inner / 2, -inner / 2}});
            }
            r.area = polygon::signed_area(r.loops);
            r.box = polygon::bounds(r.loops);
            r.parent = k == 0 ? -1 : static_cast<std::int64_t>(r.id) - 1;
            if (l > 0) r.below.push_back({r.id - static_cast<std::uint32_t>(count), r.area, 0.2, true});
            out.push_back(std::move(r));
        }
    return out;
}

TEST(FromInside, NestedShellsArePrintedFromTheInnermost) {
    for (const int count : {2, 3, 5}) {
        const auto regions = shells(6, count, 3);
        Options o;
        o.heads.common.flat_radius = 0.2;
        o.heads.common.cone_height = 100;
        o.heads.common.carriage_x = o.heads.common.carriage_y = 0;
        o.heads.common.cone_angle = 0;
        const SequenceResult before = sequence(regions, o);
        o.from_inside = true;
        const SequenceResult got = sequence(regions, o);
        EXPECT_EQ(fact(got, "planned-strokes"), count);
        EXPECT_EQ(fact(before, "planned-strokes"), count);
        EXPECT_EQ(fact(got, "outer-first"), 0);
        for (int k = 0; k < count; ++k) // stroke k is the k-th shell from the inside, from the bottom to the top
            EXPECT_EQ(got.order[static_cast<std::size_t>(k) * 6] % static_cast<std::uint32_t>(count),
                      static_cast<std::uint32_t>(count - 1 - k));
    }
}

TEST(FromInside, AFloorUnderAllShellsGoesOnToTheInnermost) {
    for (const int count : {2, 3, 5}) {
        auto regions = shells(5, count, 3);
        Region floor = regions[0];
        floor.loops = polygon::Loops{};
        floor.loops.add(regions[0].loops[0]);
        floor.area = polygon::signed_area(floor.loops);
        for (Region& r : regions) {
            ++r.layer;
            ++r.id;
            r.z += 0.2;
            if (r.parent >= 0) ++r.parent;
            for (auto& o : r.below) ++o.below;
            if (r.layer == 1) r.below.push_back({0, r.area, 0.2, true});
        }
        regions.insert(regions.begin(), floor);
        Options o;
        o.heads.common.flat_radius = 0.2;
        o.heads.common.cone_angle = 0;
        o.heads.common.cone_height = 100;
        o.heads.common.carriage_x = o.heads.common.carriage_y = 0;
        o.from_inside = true;
        const SequenceResult got = sequence(regions, o);
        EXPECT_EQ(fact(got, "planned-strokes"), count);
        EXPECT_EQ(fact(got, "outer-first"), 0);
        EXPECT_EQ(got.order[1], static_cast<Index>(count)); // the innermost shell on the floor
    }
}

// Orders from the inside keep precedences and strokes in worlds with any nesting.
TEST(FromInside, RandomWorldsKeepTheirStrokes) {
    Random random(23);
    for (int trial = 0; trial < trials(150); ++trial) {
        auto regions = random_world(random, any(random, 2, 6), 4, uniform(random, 3, 8));
        for (Region& r : regions) { // any nesting of a layer's regions will do
            const Region* outer = nullptr;
            for (const Region& u : regions)
                if (u.layer == r.layer && u.area > r.area && random() % 2 == 0) outer = &u;
            r.parent = outer == nullptr ? -1 : static_cast<std::int64_t>(outer->id);
        }
        Options o;
        o.heads.common.flat_radius = uniform(random, 0, 1);
        const SequenceResult before = sequence(regions, o);
        o.from_inside = true;
        const SequenceResult got = sequence(regions, o); // checks its precedences
        EXPECT_LE(got.stroke.back(), before.stroke.back()) << trial;
    }
}

TEST(FromInside, AnOuterShellThatMustComeFirstIsCounted) {
    auto regions = shells(3, 2, 3);
    regions[1 * 2 + 1].below.push_back({0, 0.5, 0.2, false}); // the outer shell carries the inner one
    std::erase_if(regions[1 * 2 + 1].below, [](const polygon::Overlap& o) { return o.below == 1; });
    Options o;
    o.from_inside = true;
    o.heads.common.flat_radius = 0.2;
    const SequenceResult got = sequence(regions, o);
    EXPECT_GE(fact(got, "outer-first"), 1);
}

} // namespace
} // namespace filum::sequence
