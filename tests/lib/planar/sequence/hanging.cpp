// Regions that begin in the air: what must be printed before them.
#include "sequence/hanging.hpp"

#include "worlds.hpp"

#include <cstdlib>
#include <gtest/gtest.h>

namespace filum::sequence {
namespace {

// How many parts are tried: FILUM_TRIES, or a few.
std::uint32_t tries() {
    const char* const given = std::getenv("FILUM_TRIES");
    return given != nullptr ? static_cast<std::uint32_t>(std::atoi(given)) : 60;
}

// The parts that regions are connected to by what carries them, by plain search: the least region of each.
std::vector<Index> plain_parts(const std::vector<polygon::Region>& regions) {
    std::vector<Index> part(regions.size());
    for (Index v = 0; v < regions.size(); ++v) part[v] = v;
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& r : regions)
            for (const auto& o : r.below) {
                const Index least = std::min(part[r.id], part[o.below]);
                changed = changed || part[r.id] != least || part[o.below] != least;
                part[r.id] = part[o.below] = least;
            }
    }
    return part;
}

bool carried(const polygon::Region& r) {
    return std::any_of(r.below.begin(), r.below.end(), [&](const auto& o) { return o.area > 0; });
}

// What holds of every order.
void expect_from_below(const std::vector<polygon::Region>& regions, const Order& order) {
    std::vector<Index> place(regions.size());
    for (Index i = 0; i < order.size(); ++i) place[order[i]] = i;
    const auto part = plain_parts(regions);
    std::uint32_t highest = regions.front().layer;
    for (const Index v : order) { // no layer begins before something of the one below it
        const auto next =
            std::find_if(regions.begin(), regions.end(), [&](const auto& r) { return r.layer > highest; });
        if (regions[v].layer <= highest) continue;
        ASSERT_EQ(regions[v].layer, next->layer);
        highest = regions[v].layer;
    }
    EXPECT_EQ(regions[order.front()].layer, regions.front().layer);
    for (const auto& high : regions)
        for (const auto& low : regions) {
            if (low.layer >= high.layer) continue;
            const bool of_part = !carried(high) && part[low.id] == part[high.id];
            if (!of_part && !overlap(low.loops, high.loops)) continue;
            EXPECT_LT(place[low.id], place[high.id]) << low.id << " lies below " << high.id;
        }
}

// A part with islands that begin in the air.
std::vector<polygon::Region> hanging_world(Random& random, std::uint32_t layers) {
    auto all = random_world(random, layers, 2, 6);
    std::vector<Outlined> outlined;
    for (const auto& r : all) outlined.push_back({r.layer, r.loops});
    const Index islands = any(random, 1, 3);
    for (Index i = 0; i < islands; ++i) {
        const auto b = box(uniform(random, 0, 8), uniform(random, 0, 8), 0.5, 0.5);
        const Index foot = any(random, 1, layers - 1), top = any(random, foot, layers - 1);
        for (Index l = foot; l <= top; ++l) outlined.push_back({l, b});
    }
    std::stable_sort(outlined.begin(), outlined.end(), [](const auto& a, const auto& b) { return a.layer < b.layer; });
    std::vector<Outlined> united; // of each layer
    for (std::size_t i = 0, j = 0; i < outlined.size(); i = j) {
        polygon::Loops soup;
        for (; j < outlined.size() && outlined[j].layer == outlined[i].layer; ++j)
            for (std::size_t k = 0; k < outlined[j].loops.size(); ++k) soup.add(outlined[j].loops[k]);
        for (const auto& loops : polygon::split(soup).part) united.push_back({outlined[i].layer, loops});
    }
    return world(united);
}

TEST(Hanging, EveryOrderOfRandomPartsGrowsFromBelow) {
    Random random(7);
    for (std::uint32_t i = 0; i < tries(); ++i) {
        const auto regions = hanging_world(random, any(random, 2, 8));
        for (const bool by_layers : {true, false})
            for (const bool none : {true, false}) {
                SCOPED_TRACE(std::to_string(i) + (by_layers ? " by layers" : " columns") + (none ? ", no head" : ""));
                Options o;
                o.by_layers = by_layers;
                o.heads.common.none = none;
                o.heads.common.cone_height = uniform(random, 0.5, 8);
                o.budget = 2'000'000;
                expect_from_below(regions, sequence(regions, o).order);
            }
    }
}

TEST(Hanging, FloatingPartFollowsTheNearest) {
    // two towers, and a body that floats beside the second
    std::vector<Outlined> outlined;
    for (std::uint32_t l = 0; l < 6; ++l) {
        outlined.push_back({l, box(0, 0, 5, 5)});
        outlined.push_back({l, box(100, 0, 5, 5)});
        if (l >= 3) outlined.push_back({l, box(110, 0, 5, 5)});
    }
    const auto regions = world(outlined);
    Graph g = support_graph(regions);
    std::vector<Outline> outlines;
    for (const auto& r : regions) outlines.push_back(outline(r.loops));
    EXPECT_EQ(below_hanging(g, outlines), (std::vector<Pair>{{5, 8}}));
}

TEST(Hanging, WhatASupportCarriesAcrossAGapFollowsTheLayerOfTheGap) {
    // A tower; beside it a support of one layer, an empty layer, and the body on the support.
    std::vector<Outlined> outlined;
    for (std::uint32_t l = 0; l < 5; ++l) {
        outlined.push_back({l, box(0, 0, 5, 5)});
        if (l != 1) outlined.push_back({l, box(10, 0, 5, 5)});
    }
    auto regions = world(outlined);
    const Index support = 1, in_gap = 2, body = 4;
    ASSERT_EQ(regions[body].layer, 2U);
    regions[body].below.push_back({support, 25, 0.2, false});
    for (const bool by_layers : {true, false}) {
        Options o;
        o.by_layers = by_layers;
        o.heads.common.none = true;
        const Order order = sequence(regions, o).order;
        const auto place = [&](Index v) { return std::ranges::find(order, v) - order.begin(); };
        EXPECT_LT(place(in_gap), place(body));
        EXPECT_LT(place(support), place(body));
    }
}

TEST(Hanging, OfManyTheNearestCome) {
    // a row of pillars and a row of stalactites that one roof joins
    constexpr std::uint32_t kMany = 400;
    std::vector<Outlined> outlined;
    for (std::uint32_t l = 0; l < 2; ++l) {
        for (std::uint32_t i = 0; i < kMany; ++i) outlined.push_back({l, box(2 * i, 0, 1, 1)});
        for (std::uint32_t i = 0; i < kMany && l == 1; ++i) outlined.push_back({l, box(2 * i, 2, 1, 1)});
    }
    outlined.push_back({2, box(0, 0, 2 * kMany, 3)});
    const auto regions = world(outlined);
    Graph g = support_graph(regions);
    std::vector<Outline> outlines;
    for (const auto& r : regions) outlines.push_back(outline(r.loops));
    const auto pairs = below_hanging(g, outlines);
    EXPECT_EQ(pairs.size(), kMany * kMostBelow);
    EXPECT_TRUE(std::find(pairs.begin(), pairs.end(), Pair(0, 2 * kMany)) != pairs.end());
}

} // namespace
} // namespace filum::sequence
