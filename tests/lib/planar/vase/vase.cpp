#include "vase/vase.hpp"

#include "../fill/pattern_check.hpp"
#include "base/error.hpp"
#include "infill/infill.hpp"
#include "polygon/clip.hpp"
#include "polygon/stack.hpp"
#include "regions/regions.hpp"

#include <gtest/gtest.h>

namespace filum::vase {
namespace {

using polygon::Loops;
using polygon::Region;

Loops box(double x0, double y0, double x1, double y1) { return test::loop({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}); }

// The regions of a part, layer by layer, each 0.2 mm high.
std::vector<Region> part(const std::vector<Loops>& layers) {
    std::vector<Region> out;
    regions::Air air;
    std::size_t before = 0;
    for (std::size_t l = 0; l < layers.size(); ++l) {
        Notes notes;
        const double z = 0.2 * static_cast<double>(l + 1);
        const polygon::Layer layer{static_cast<std::uint32_t>(l), z, 0.2, z - 0.1, layers[l]};
        auto now = regions::regions(layer, {}, notes);
        const std::size_t first = out.size();
        for (Region& r : now) {
            r.id += static_cast<std::uint32_t>(first);
            if (r.parent >= 0) r.parent += static_cast<std::int64_t>(first);
        }
        const std::span below(out.data() + before, first - before);
        regions::lay_on(now, {l == 0, below}, {}, air);
        before = first;
        for (Region& r : now) out.push_back(std::move(r));
    }
    return out;
}

std::vector<Region> made(const std::vector<Region>& from, const Options& options, Notes& notes) {
    Facts facts;
    auto out = vase(from, options, notes, facts);
    EXPECT_EQ(polygon::fault(out), "");
    return out;
}

bool has(const Notes& notes, NoteCode code) {
    return std::any_of(notes.begin(), notes.end(), [&](const Note& n) { return n.code == code; });
}

TEST(Vase, ACupAndASolidPartGiveTheSame) {
    const Loops full = box(0, 0, 20, 20), ring = polygon::subtract(full, box(2, 2, 18, 18));
    Notes notes;
    const auto solid = made(part({full, full, full, full, full}), {.bottom = 3}, notes);
    const auto cup = made(part({full, ring, ring, ring, ring}), {.bottom = 3}, notes);
    ASSERT_EQ(solid.size(), 5U);
    ASSERT_EQ(cup.size(), 5U);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_NEAR(cup[k].area, 400, 1e-6);
        EXPECT_EQ(cup[k].areas.size(), k < 3 ? 0U : 1U);
        EXPECT_EQ(cup[k].below.size(), k == 0 ? 0U : 1U);
    }
    EXPECT_GE(cup[4].areas[0].spacing, infill::kHollow);
    EXPECT_TRUE(notes.empty());
}

TEST(Vase, AHoleFromTheBedOnStaysOpenInTheFloor) {
    const Loops full = box(0, 0, 20, 20), hole = polygon::subtract(full, box(9, 9, 11, 11)),
                ring = polygon::subtract(full, box(2, 2, 18, 18));
    Notes notes;
    const auto pot = made(part({hole, hole, ring, ring, ring}), {.bottom = 4}, notes);
    for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(pot[k].area, 396, 1e-6) << k;
    EXPECT_NEAR(pot[4].area, 400, 1e-6);
}

TEST(Vase, ItEndsWhereThePartBranches) {
    const Loops full = box(0, 0, 20, 10), towers = polygon::unite(box(0, 0, 6, 10), box(14, 0, 20, 10));
    Notes notes;
    EXPECT_EQ(made(part({full, full, full, towers, towers}), {.bottom = 1}, notes).size(), 3U);
    ASSERT_TRUE(has(notes, NoteCode::vase_ends));
    EXPECT_NEAR(notes[0].amount, 2 * 120 * 0.2, 1e-3);
    notes.clear();
    EXPECT_THROW(made(part({full, towers, towers}), {.bottom = 1}, notes), Error);
    // two feet, and a body on both
    notes.clear();
    EXPECT_EQ(made(part({towers, towers, full}), {.bottom = 1}, notes).size(), 4U);
    EXPECT_TRUE(has(notes, NoteCode::vase_ends));
}

TEST(Vase, WhatLiesWithinIsToldAndWhatHangs) {
    const Loops full = box(0, 0, 20, 20), ring = polygon::subtract(full, box(2, 2, 18, 18)),
                both = polygon::unite(ring, box(8, 8, 12, 12));
    Notes notes;
    made(part({full, both, both}), {.bottom = 1}, notes);
    EXPECT_TRUE(has(notes, NoteCode::vase_within));
    EXPECT_FALSE(has(notes, NoteCode::vase_hangs));
    notes.clear();
    made(part({full, full, box(-1, -1, 21, 21), box(-1, -1, 21, 21)}), {.bottom = 1}, notes);
    EXPECT_TRUE(has(notes, NoteCode::vase_hangs));
    notes.clear(); // 45 degrees, layers half as high as the bead is wide
    made(part({full, full, box(-.2, 0, 20.2, 20), box(-.4, 0, 20.4, 20)}), {.bottom = 1}, notes);
    EXPECT_FALSE(has(notes, NoteCode::vase_hangs));
}

} // namespace
} // namespace filum::vase
