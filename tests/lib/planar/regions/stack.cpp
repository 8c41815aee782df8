#include "regions/stack.hpp"

#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum::regions {
namespace {

// 40 layers of boxes that move on, some in mid-air; layers 5, 16 and 30 are missing.
std::vector<polygon::Layer> layers() {
    std::vector<polygon::Layer> out;
    for (std::uint32_t i = 0; i < 40; ++i) {
        if (i == 5 || i == 16 || i == 30) continue;
        Loops l = box(0.05 * i, 0, 10, 10);
        add_box(l, 0.05 * i + 2, 2, 3, 3, true);
        if (i % 7 == 3) add_box(l, 20.0 + i, 0, 4, 4);
        add_box(l, 0, 20, 3, 0.04); // a sliver
        polygon::Layer layer = regions::layer(std::move(l));
        layer.index = i;
        out.push_back(std::move(layer));
    }
    return out;
}

void expect_same(const polygon::Region& a, const polygon::Region& b) {
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.layer, b.layer);
    EXPECT_EQ(a.parent, b.parent);
    EXPECT_EQ(a.loops.points, b.loops.points);
    EXPECT_EQ(a.unsupported, b.unsupported);
    ASSERT_EQ(a.below.size(), b.below.size());
    for (std::size_t k = 0; k < a.below.size(); ++k) {
        EXPECT_EQ(a.below[k].below, b.below[k].below);
        EXPECT_EQ(a.below[k].area, b.below[k].area);
        EXPECT_EQ(a.below[k].link, b.below[k].link);
    }
}

TEST(Stack, GivesWhatOneLayerAfterTheOtherGives) {
    const auto all = layers();
    std::vector<polygon::Region> expected, below;
    Notes expected_notes;
    Air expected_air;
    std::int64_t last = -2;
    std::uint32_t id = 0;
    for (const auto& layer : all) {
        auto now = regions(layer, {}, expected_notes);
        for (auto& r : now) r.id += id;
        id += static_cast<std::uint32_t>(now.size());
        if (layer.index != last + 1) below.clear();
        lay_on(now, {last == -2, below}, {}, expected_air);
        last = layer.index;
        expected.insert(expected.end(), now.begin(), now.end());
        below = now;
    }
    ASSERT_GT(expected_air.layers, 5U);
    for (const int threads : {1, 2, 8}) {
        Stack stack({}, threads);
        std::vector<polygon::Region> got;
        Notes notes;
        const auto take = [&](std::vector<polygon::Region> some) { got.insert(got.end(), some.begin(), some.end()); };
        for (const auto& layer : all) take(stack.add(layer, notes));
        take(stack.end(notes));
        ASSERT_EQ(got.size(), expected.size());
        for (std::size_t k = 0; k < got.size(); ++k) expect_same(got[k], expected[k]);
        ASSERT_EQ(notes.size(), expected_notes.size());
        for (std::size_t k = 0; k < notes.size(); ++k) EXPECT_EQ(notes[k].layer, expected_notes[k].layer);
        EXPECT_NEAR(stack.air().area, expected_air.area, 1e-9);
        EXPECT_EQ(stack.air().layers, expected_air.layers);
        EXPECT_EQ(stack.air().layer, expected_air.layer);
        EXPECT_EQ(stack.air().at, expected_air.at);
        EXPECT_TRUE(stack.end(notes).empty());
    }
}

// Two boxes side by side: one on every layer, the other, of tool 1, on every n-th one and n layers high.
std::vector<polygon::Layer> with_high_layers(std::uint32_t n, std::uint32_t count, std::uint32_t bottom) {
    std::vector<polygon::Layer> out;
    for (std::uint32_t i = 0; i < count; ++i) {
        polygon::Layer low = regions::layer(box(0, 0, 10, 10));
        low.index = i;
        low.z = 0.2 * (i + 1);
        out.push_back(low);
        if (i < bottom || (i - bottom + 1) % n != 0) continue;
        polygon::Layer high = regions::layer(box(10, 0, 10, 10));
        high.index = i;
        high.z = low.z;
        high.height = 0.2 * n;
        high.layers = n;
        high.body = high.tool = 1;
        high.width = 2 * n;
        out.push_back(high);
    }
    return out;
}

TEST(Stack, HighLayersLieOnTheLayerWhereTheyBegin) {
    for (const std::uint32_t n : {2U, 3U, 5U, 16U})
        for (const std::uint32_t bottom : {0U, 1U, 7U, 20U})
            for (const int threads : {1, 8}) {
                Stack stack({}, threads);
                Notes notes;
                std::vector<polygon::Region> got;
                for (const auto& layer : with_high_layers(n, 70, bottom))
                    for (auto& r : stack.add(layer, notes)) got.push_back(std::move(r));
                for (auto& r : stack.end(notes)) got.push_back(std::move(r));
                std::size_t high = 0;
                for (const auto& r : got) {
                    ASSERT_LE(r.below.size(), 1U);
                    const bool lowest = r.tool == 1 && r.layer + 1 < bottom + 2 * n;
                    if (r.rests_on() < 0 || lowest) {
                        EXPECT_TRUE(r.below.empty());
                        EXPECT_EQ(r.unsupported > 0, r.rests_on() >= 0); // the first high layer may begin in the air
                        continue;
                    }
                    ASSERT_EQ(r.below.size(), 1U);
                    const auto& below = got[r.below[0].below];
                    EXPECT_EQ(below.layer, r.rests_on());
                    EXPECT_EQ(below.tool, r.tool);
                    EXPECT_TRUE(r.below[0].link);
                    EXPECT_EQ(r.unsupported, 0);
                    high += r.tool == 1 ? 1 : 0;
                }
                EXPECT_GT(high, 0U);
                EXPECT_EQ(stack.gaps().layers, 0U);
            }
}

} // namespace
} // namespace filum::regions
