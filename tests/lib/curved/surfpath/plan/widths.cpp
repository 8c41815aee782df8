// Beads are as wide as the room between their lines.
#include "surfpath/plan/widths.hpp"

#include "../plate_lines.hpp"
#include "base/mix.hpp"
#include "surfpath/plan/coverage.hpp"

#include <gtest/gtest.h>

namespace filum::surfpath::widths {

using namespace plan;

namespace {

Plan plan_of(const Surface& s, bool rolled, const std::vector<double>& heights) {
    Plan out;
    for (const double y : heights) out.strokes.push_back({{{line_through(s, rolled, {{0.5, y}, {59.5, y}}), false}}});
    return out;
}

// The width that the room around a line gives, from the definition.
double expected(const std::vector<double>& heights, std::size_t i, double change) {
    const double most = (1 + change) / 2;
    const double below = i == 0 ? heights[i] : (heights[i] - heights[i - 1]) / 2;
    const double above = i + 1 == heights.size() ? 40 - heights[i] : (heights[i + 1] - heights[i]) / 2;
    return std::max(1 - change, std::min(most, below) + std::min(most, above));
}

TEST(Widths, RandomParallelLinesGetTheRoomBetweenThem) {
    std::uint64_t seed = 5;
    const auto uniform = [&] { return next_share(seed); };
    for (int trial = 0; trial < 3; ++trial) {
        const bool rolled = trial % 2 == 1;
        const double change = 0.05 + 0.25 * uniform();
        const Surface s = plate(rolled);
        std::vector<double> heights{0.3 + 0.4 * uniform()};
        while (heights.back() < 38.5) heights.push_back(heights.back() + 0.7 + 0.7 * uniform());
        Plan plan = plan_of(s, rolled, heights);
        fit_widths(s, plan, {1, change});
        for (std::size_t i = 0; i < heights.size(); ++i) {
            const Section& section = plan.strokes[i].sections[0];
            ASSERT_EQ(section.widths.size(), section.line.size());
            for (std::size_t k = 0; k < section.widths.size(); ++k) {
                EXPECT_GE(section.widths[k], 1 - change - 0.011);
                EXPECT_LE(section.widths[k], 1 + change + 0.011);
                const double x = section.line[k].x;
                if (k % 40 != 20 || x < 2 || (!rolled && x > 58)) continue;
                EXPECT_NEAR(section.widths[k], expected(heights, i, change), 0.03) << trial << " " << i << " " << k;
            }
        }
    }
}

// Lines 1.15 mm apart leave 13 % of the surface open with beads of one width, and nothing with wider ones.
TEST(Widths, WiderBeadsFillGaps) {
    const Surface s = plate(false);
    std::vector<double> heights;
    for (double y = 0.5; y < 39.8; y += 1.15) heights.push_back(y);
    Plan plan = plan_of(s, false, heights);
    const Coverage before = cover(s, plan, 1);
    fit_widths(s, plan, {1, 0.2});
    const Coverage after = cover(s, plan, 1);
    EXPECT_GT(before.voids(), 0.1 * before.surface);
    EXPECT_LT(after.voids(), 0.02 * after.surface);
    EXPECT_LT(after.overlap(), 0.01 * after.surface);
}

} // namespace
} // namespace filum::surfpath::widths
