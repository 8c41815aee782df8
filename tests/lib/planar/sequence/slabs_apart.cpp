// Orders that wait at pauses.
#include "sequence/slabs_apart.hpp"
#include "worlds.hpp"

#include <gtest/gtest.h>

namespace filum::sequence {

namespace {

TEST(SlabsApart, AllBelowAPauseComesFirst) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        Random random(seed);
        const auto regions = random_world(random, 12, 3, 30);
        Options options;
        options.budget = 1'000'000;
        const auto pauses = machine::parse_pauses(seed % 2 == 0 ? "4,1.6mm" : "7");
        const SequenceResult r = sequence_apart(regions, options, pauses);
        ASSERT_EQ(r.order.size(), regions.size());
        std::vector<char> seen(regions.size(), 0);
        std::size_t passed = 0;
        for (std::size_t i = 0; i < r.order.size(); ++i) {
            const auto& region = regions[r.order[i]];
            EXPECT_EQ(std::exchange(seen[r.order[i]], 1), 0);
            const std::size_t now = pauses.before(region.layer, region.z, region.height);
            EXPECT_GE(now, passed);
            if (now > passed) {
                EXPECT_EQ(r.join[i], Join::start);
            }
            passed = now;
            for (const auto& o : region.below) EXPECT_EQ(seen[o.below], 1);
            if (r.join[i] == Join::vertical) {
                EXPECT_EQ(r.stroke[i], r.stroke[i - 1]);
                EXPECT_EQ(regions[r.order[i - 1]].layer + 1, region.layer);
            } else {
                EXPECT_EQ(r.stroke[i], i == 0 ? 0 : r.stroke[i - 1] + 1);
            }
        }
        EXPECT_EQ(passed, pauses.count());
        double planned = 0, bound = 0;
        for (const Fact& f : r.facts) {
            if (f.name == "planned-strokes") planned = f.value;
            if (f.name == "lower-bound") bound = f.value;
        }
        EXPECT_EQ(planned, r.stroke.back() + 1);
        EXPECT_LE(bound, planned);
    }
}

TEST(SlabsApart, WithoutAPauseItIsTheOrderItself) {
    Random random(5);
    const auto regions = random_world(random, 8, 3, 30);
    Options options;
    options.budget = 1'000'000;
    EXPECT_EQ(sequence_apart(regions, options, {}).order, sequence(regions, options).order);
}

} // namespace

} // namespace filum::sequence
