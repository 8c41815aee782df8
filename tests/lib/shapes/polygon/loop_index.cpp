// Keeps the inside and the outside of all loops within the box that is asked for.
#include "polygon/loop_index.hpp"

#include <gtest/gtest.h>

#include <random>

using namespace filum::polygon;

TEST(LoopIndex, LoopsNearABoxDecideWhatIsInsideThere) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> some(0, 1);
    for (int round = 0; round < 60; ++round) {
        Loops all; // nested, crossing and far loops
        for (int l = 0; l < round; ++l) {
            const Vec2 middle{30 * some(random), 30 * some(random)};
            const double size = l % 5 == 0 ? 25 : 3;
            for (int k = 0; k < 5; ++k)
                all.points.push_back(middle + size * Vec2{some(random) - 0.5, some(random) - 0.5});
            all.close();
        }
        const LoopIndex index(all);
        std::size_t fewest = all.size();
        for (int k = 0; k < 40; ++k) {
            const Vec2 lo{30 * some(random), 30 * some(random)}, hi = lo + Vec2{2 * some(random), 2 * some(random)};
            const Loops near = index.near({lo, hi});
            fewest = std::min(fewest, near.size());
            for (int i = 0; i < 20; ++i) {
                const Vec2 p{lo.x + (hi.x - lo.x) * some(random), lo.y + (hi.y - lo.y) * some(random)};
                EXPECT_EQ(contains(near, p), contains(all, p)) << round << ": " << p.x << ' ' << p.y;
            }
        }
        if (round > 30) {
            EXPECT_LT(fewest, all.size() / 2);
        }
    }
}

TEST(LoopIndex, OfNothingIsNothing) { EXPECT_TRUE(LoopIndex().near({{0, 0}, {1, 1}}).empty()); }
