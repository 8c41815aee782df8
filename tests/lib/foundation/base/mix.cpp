#include "base/mix.hpp"

#include <gtest/gtest.h>

#include <set>

namespace filum {
namespace {

// The first numbers of splitmix64 from the seed 1234567, as its authors' code gives them.
TEST(Mix, IsSplitmix64) {
    std::uint64_t state = 1234567;
    for (const std::uint64_t expected : {6457827717110365317U, 3203168211198807973U, 9817491932198370423U,
                                         4593380528125082431U, 16408922859458223821U})
        EXPECT_EQ(mixed(state += kMixStep), expected);
}

TEST(Mix, SharesLieBelowOneAndDiffer) {
    std::uint64_t state = 7;
    std::set<double> seen;
    double sum = 0;
    for (int i = 0; i < 10000; ++i) {
        const double u = next_share(state);
        ASSERT_TRUE(u >= 0 && u < 1);
        seen.insert(u);
        sum += u;
    }
    EXPECT_EQ(seen.size(), 10000U);
    EXPECT_NEAR(sum / 10000, 0.5, 0.01);
    EXPECT_LT(as_share(~std::uint64_t{0}), 1);
}

} // namespace
} // namespace filum
