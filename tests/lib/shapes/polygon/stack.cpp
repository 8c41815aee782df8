// What regions of a stream are checked for, and layer numbers that are no indices.
#include "polygon/stack.hpp"
#include "polygon/clip.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace filum;
using namespace filum::polygon;

namespace stack {

Loops ring(std::vector<Vec2> points, bool turned = false) {
    if (turned) std::reverse(points.begin(), points.end());
    Loops out;
    out.add(points);
    return out;
}

std::vector<Vec2> square(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(OutlineFault, FindsWhatIsNoArea) {
    EXPECT_EQ(fault(ring(square(0, 0, 10))), "");
    EXPECT_NE(fault(ring(square(0, 0, 10), true)), "");               // clockwise
    EXPECT_NE(fault(ring({{0, 0}, {10, 10}, {10, 0}, {0, 10}})), ""); // a bow-tie, as large on both sides
    EXPECT_NE(fault(ring({{0, 0}, {12, 10}, {12, 0}, {0, 10}})), "");
    Loops with_hole = ring(square(0, 0, 10));
    with_hole.add(ring(square(2, 2, 3), true));
    EXPECT_EQ(fault(with_hole), "");
    Loops filled = ring(square(0, 0, 10)); // the hole runs like the outline
    filled.add(ring(square(2, 2, 3)));
    EXPECT_NE(fault(filled), "");
    Loops outside = ring(square(0, 0, 10));
    outside.add(ring(square(20, 2, 3), true));
    EXPECT_NE(fault(outside), "");
    Loops touching = ring(square(0, 0, 10)); // in one point
    touching.add(ring(square(10, 10, 5)));
    EXPECT_EQ(fault(touching), "");
}

// Areas as the toolbox makes them have no fault; with a loop turned or two points swapped across they have.
TEST(OutlineFault, TellsRandomAreasFromTurnedOnes) {
    std::mt19937 random(4);
    const auto any = [&](double to) { return to * (static_cast<double>(random()) / 4294967296.0); };
    int areas = 0;
    for (int trial = 0; trial < 200; ++trial) {
        Loops a;
        for (int k = 0; k < 5; ++k) a = unite(a, ring(square(any(20), any(20), 2 + any(8))));
        a = subtract(a, ring(square(any(20), any(20), 1 + any(3))));
        if (a.empty()) continue;
        ++areas;
        EXPECT_EQ(fault(a), "") << trial;
        const std::size_t l = random() % a.size();
        std::reverse(a.points.begin() + a.start[l], a.points.begin() + a.start[l + 1]);
        EXPECT_NE(fault(a), "") << trial;
    }
    EXPECT_GT(areas, 150);
}

std::vector<Region> on_layers(const std::vector<std::uint32_t>& layers) {
    std::vector<Region> out;
    for (const std::uint32_t layer : layers) {
        Region r;
        r.id = static_cast<std::uint32_t>(out.size());
        r.layer = layer;
        r.z = 0.2 * (layer + 1.0);
        out.push_back(r);
    }
    return out;
}

TEST(CloseGaps, KeepsOrderAndShortGaps) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 300; ++trial) {
        std::vector<std::uint32_t> layers;
        std::uint64_t at = random() % 3 == 0 ? random() : random() % 5;
        for (int k = 0; k < 20 && at <= 0xffffffffU; ++k) {
            for (unsigned n = 1 + random() % 3; n > 0; --n) layers.push_back(static_cast<std::uint32_t>(at));
            at += random() % 5 == 0 ? random() : random() % 6;
        }
        auto regions = on_layers(layers);
        const std::uint32_t most = random() % 5;
        const auto original = close_gaps(regions, most);
        ASSERT_LE(original.size(), layers.size() * (most + 1));
        EXPECT_TRUE(std::is_sorted(original.begin(), original.end()));
        for (std::size_t i = 0; i < layers.size(); ++i) {
            EXPECT_EQ(original[regions[i].layer], layers[i]);
            if (i == 0) continue;
            const std::uint32_t given = layers[i] - layers[i - 1], now = regions[i].layer - regions[i - 1].layer;
            EXPECT_EQ(now, std::min(given, most + 1));
        }
    }
}

TEST(RegionsFault, FindsWrongIdsAndLayers) {
    auto regions = on_layers({0, 0, 1, 4000000000U, 0xffffffffU});
    regions[2].below.push_back({0, 1, 1, true});
    regions[1].parent = 0;
    EXPECT_EQ(fault(regions), "");
    const auto broken = [&](auto change) {
        auto copy = regions;
        change(copy);
        return fault(copy);
    };
    EXPECT_NE(broken([](auto& r) { r[1].id = 0; }), "");
    EXPECT_NE(broken([](auto& r) { r[2].below[0].below = 7; }), "");
    EXPECT_NE(broken([](auto& r) { r[2].below[0].below = 0xffffffffU; }), "");
    EXPECT_NE(broken([](auto& r) { r[2].below[0].below = 3; }), "");
    EXPECT_NE(broken([](auto& r) { r[1].parent = 1; }), "");
    EXPECT_NE(broken([](auto& r) { r[1].parent = 2; }), "");
    EXPECT_NE(broken([](auto& r) { r[0].brim = std::int64_t{1} << 40; }), "");
    EXPECT_NE(broken([](auto& r) { std::swap(r[0], r[3]); }), "");
    EXPECT_NE(broken([](auto& r) { r[3].z = 0; }), "");
}

} // namespace stack
