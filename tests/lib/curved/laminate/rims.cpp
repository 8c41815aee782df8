// Depths at which plies turn: as far apart as the beads along rims allow.
#include "laminate/rims.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace filum::laminate {
namespace {

// The open area per spacing of the rim, in square spacings.
double open_area(const RimBeads& ply) {
    double sum = 0;
    for (int i = 0; i < 5000; ++i) sum += open_share(ply, (i + 0.5) / 1000) / 1000;
    return sum;
}

TEST(RimBeads, TurnsLeaveOpenWhatHalfCirclesLeave) {
    constexpr double kAll = 1 - std::numbers::pi / 4;
    EXPECT_NEAR(open_area({0, 1}), kAll, 1e-3);
    EXPECT_EQ(open_share({0, 1}, 0), 1);
    EXPECT_EQ(open_share({0, 1}, 1), 0);
    // On a bead along the rim, the strip of kAll spacings is covered twice where it is not open.
    double twice = 0;
    for (int i = 0; i < 1000; ++i) twice += (1 - open_share({0, 1}, kAll * (i + 0.5) / 1000)) * kAll / 1000;
    for (const double width : {0.8, 1.0, 1.2}) EXPECT_NEAR(open_area({2, width}), twice, 1e-3);
    EXPECT_EQ(open_share({2, 1}, 1.9), 0);
}

// The greatest sum of open shares at any distance from the rim, sampled.
double greatest_sum(const std::vector<RimBeads>& plies) {
    double most = 0;
    for (double x = 0; x < 12; x += 0.005) {
        double sum = 0;
        for (const RimBeads& ply : plies) sum += open_share(ply, x);
        most = std::max(most, sum);
    }
    return most;
}

TEST(RimBeads, LessIsOpenAtOneDistanceThanWithNumbersOfBeadsInTurn) {
    std::mt19937 random(3);
    for (int i = 0; i < 100; ++i) {
        const std::size_t plies = 1 + random() % 24;
        const long most = static_cast<long>(random() % 9);
        const double change = i % 3 == 0 ? 0 : 0.05 * static_cast<double>(random() % 7);
        const auto found = rim_beads(plies, most, change);
        ASSERT_EQ(found.size(), plies);
        std::vector<RimBeads> in_turn, from_one;
        for (std::size_t k = 0; k < plies; ++k) {
            in_turn.push_back({static_cast<long>(k % static_cast<std::size_t>(most + 1)), 1});
            from_one.push_back({most > 0 ? 1 + static_cast<long>(k % static_cast<std::size_t>(most)) : 0, 1});
            EXPECT_LE(found[k].count, most);
            EXPECT_GE(found[k].width, 1 - change - 1e-9);
            EXPECT_LE(found[k].width, 1 + change + 1e-9);
        }
        EXPECT_LE(greatest_sum(found), greatest_sum(in_turn) + 0.02) << plies << ", " << most << ", " << change;
        EXPECT_LE(greatest_sum(found), greatest_sum(from_one) + 0.02) << plies << ", " << most << ", " << change;
    }
}

TEST(RimBeads, EightPliesWithThreeBeadsTurnAtEightDepths) {
    auto found = rim_beads(8, 3, 0.2);
    std::sort(found.begin(), found.end(), [](const RimBeads& a, const RimBeads& b) { return a.depth() < b.depth(); });
    EXPECT_NEAR(found[0].depth(), 0.8, 1e-9);
    for (std::size_t k = 1; k < 8; ++k) EXPECT_NEAR(found[k].depth() - found[k - 1].depth(), 0.4, 1e-6) << k;
    for (const RimBeads& ply : rim_beads(8, 0, 0.2)) EXPECT_EQ(ply.count, 0);
}

} // namespace
} // namespace filum::laminate
