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

} // namespace
} // namespace filum::regions
