#include "sequence/brims.hpp"
#include "base/error.hpp"
#include "worlds.hpp"

#include <gtest/gtest.h>

namespace filum::sequence {
namespace {

// The boxes of random worlds, a brim about each of the first layer.
std::vector<polygon::Region> with_brims(const std::vector<polygon::Region>& world) {
    const auto first = static_cast<std::uint32_t>(
        std::count_if(world.begin(), world.end(), [](const polygon::Region& r) { return r.layer == 0; }));
    std::vector<polygon::Region> out(world.begin(), world.begin() + first);
    for (std::uint32_t i = 0; i < first; ++i) {
        out[i].brim = first + i;
        polygon::Region rim = world[i];
        rim.id = first + i;
        rim.is = polygon::RegionClass::rim;
        rim.loops = polygon::subtract(polygon::offset(world[i].loops, 1, 0.01), world[i].loops);
        out.push_back(std::move(rim));
    }
    for (std::size_t i = first; i < world.size(); ++i) {
        out.push_back(world[i]);
        out.back().id += first;
        for (auto& o : out.back().below) o.below += o.below >= first ? first : 0;
    }
    return out;
}

TEST(Brims, CostNoStroke) {
    Random random(3);
    for (int trial = 0; trial < 20; ++trial) {
        const auto world = random_world(random, 12, 4, 60);
        Options o;
        o.budget = 1'000'000;
        o.heads.common.none = true;
        const auto all = with_brims(world);
        const SequenceResult plain = sequence(world, o), r = sequence(all, o);
        EXPECT_EQ(fact(r, "planned-strokes"), fact(plain, "planned-strokes"));
        EXPECT_EQ(fact(r, "lower-bound"), fact(plain, "lower-bound"));
        EXPECT_EQ(fact(r, "layer-floor"), fact(plain, "layer-floor"));
        EXPECT_EQ(r.stroke.back() + 1, fact(r, "planned-strokes"));
        EXPECT_EQ(r.ends.size(), fact(r, "planned-strokes"));
        for (std::size_t i = 0; i < r.order.size(); ++i) {
            const auto& region = all[r.order[i]];
            EXPECT_EQ(r.join[i] == Join::beside, region.brim >= 0);
            if (region.brim < 0) continue;
            ASSERT_GT(i, 0U);
            EXPECT_EQ(r.order[i - 1], region.brim);
            EXPECT_EQ(r.join[i - 1], Join::start);
            EXPECT_EQ(r.stroke[i - 1], r.stroke[i]);
        }
    }
}

// What stands within the head's reach of a brim comes after it.
TEST(Brims, TheHeadHasRoomOverThem) {
    Random random(4);
    for (int trial = 0; trial < 20; ++trial) {
        const auto all = with_brims(random_world(random, 12, 4, 30));
        Options o;
        o.budget = 1'000'000;
        const SequenceResult r = sequence(all, o);
        std::vector<std::size_t> place(all.size());
        for (std::size_t i = 0; i < r.order.size(); ++i) place[r.order[i]] = i;
        for (const auto& low : all)
            for (const auto& high : all) {
                if (low.is != polygon::RegionClass::rim || high.z <= low.z || place[low.id] < place[high.id]) continue;
                EXPECT_FALSE(within(outline(high.loops), outline(low.loops), reach(o.heads.common, high.z - low.z)));
            }
    }
}

// An island that begins in the air beside a brim waits for the brim, and so for the region of that brim, which may
// stand far away from it. With a head or without, and with any other precedences: the order keeps every precedence
// (or sequence() throws), and each brim is printed just before its region.
TEST(Brims, StayBeforeTheirRegionsBesideHangingIslands) {
    Random random(6);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<Outlined> outlined;
        for (const auto& r : random_world(random, 6, 3, 20)) outlined.push_back({r.layer, r.loops});
        for (Index island = 0; island < 3; ++island) {
            const auto b = box(uniform(random, -3, 23), uniform(random, -3, 23), 0.5, 0.5);
            for (Index l = any(random, 1, 3); l < 6; ++l) outlined.push_back({l, b});
        }
        std::ranges::stable_sort(outlined, {}, &Outlined::layer);
        const auto all = with_brims(world(outlined));
        Options o;
        o.budget = 300'000;
        o.heads.common.none = trial % 2 == 0;
        o.heads.common.cone_height = 0.5;
        const SequenceResult r = sequence(all, o);
        for (std::size_t i = 0; i < r.order.size(); ++i)
            if (all[r.order[i]].brim >= 0) {
                EXPECT_EQ(r.order[i - 1], all[r.order[i]].brim) << "trial " << trial;
            }
    }
}

// A skirt fills the nozzle, so it is the first that its tool prints, wherever it lies, beside any regions.
TEST(Skirts, ComeFirst) {
    Random random(5);
    for (int trial = 0; trial < 20; ++trial) {
        auto all = with_brims(random_world(random, 12, 4, 60));
        polygon::Region* some = nullptr; // loses its brim, which is a skirt then
        std::int64_t skirt = -1;
        for (auto& r : all)
            if (r.brim >= 0 && (some == nullptr || trial % 2 == 0)) some = &r;
        ASSERT_NE(some, nullptr);
        std::swap(some->brim, skirt);
        Options o;
        o.budget = 1'000'000;
        for (const bool layers : {false, true}) {
            o.by_layers = layers;
            const SequenceResult r = sequence(all, o);
            EXPECT_EQ(r.order.front(), skirt);
            EXPECT_EQ(r.join.front(), Join::start);
            EXPECT_EQ(r.join[1], Join::start);
            EXPECT_EQ(r.stroke.back() + 1, fact(r, "planned-strokes"));
        }
        o.by_layers = false;
        all[static_cast<std::size_t>(skirt)].tool = 1;
        const SequenceResult r = sequence(all, o);
        EXPECT_NE(std::ranges::find(r.order, static_cast<Index>(skirt)), r.order.end());
    }
}

TEST(Brims, AreOfTheSameLayer) {
    auto all = with_brims(world({{0, box(0, 0, 5, 5)}, {1, box(0, 0, 5, 5)}}));
    for (const std::int64_t wrong : {0, 2, 9}) {
        all[0].brim = wrong;
        EXPECT_THROW((void)sequence(all, {}), Error) << wrong;
    }
}

} // namespace
} // namespace filum::sequence
