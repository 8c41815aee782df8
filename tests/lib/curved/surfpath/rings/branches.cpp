// Levels of rings on trees whose answers are known, and on random ones.
#include "surfpath/rings/branches.hpp"

#include "surface/surface.hpp"

#include "../../../trials.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace filum::surfpath {

using namespace rings;
namespace {

using surface::kNone;

// Isles one in the other, rings `around` mm long, up to `top`.
std::vector<Isle> lone(double top, double spacing, double around) {
    std::vector<Isle> out;
    for (std::uint32_t i = 0; (i + 0.5) * spacing < top; ++i)
        out.push_back({i, i == 0 ? kNone : i - 1, top, around, around, {}});
    return out;
}

TEST(Branches, OfOneMaximumEndsHalfASpacingBelowIt) {
    for (const double top : {8.0, 8.1, 8.3, 8.5, 8.6, 8.9}) {
        std::vector<std::uint32_t> of;
        const auto all = branches(lone(top, 1, 50), {1, 0, false}, of);
        ASSERT_EQ(all.size(), 1U);
        EXPECT_TRUE(all[0].closed);
        EXPECT_NEAR(all[0].levels.front(), 0.5, 1e-12);
        EXPECT_NEAR(all[0].levels.back(), top - 0.5, 1e-9) << top;
        // One ring more, unless one less costs less than half as much.
        EXPECT_EQ(all[0].levels.size(), top - std::floor(top) < 1.0 / 3 ? 8U : 9U) << top;
    }
}

TEST(Branches, ChangeSpacingsWhereRingsAreShortest) {
    auto isles = lone(8.25, 1, 50);
    isles[3].around = 10;
    isles[5].around = 20;
    std::vector<std::uint32_t> of;
    const auto levels = branches(isles, {1, 0, false}, of).at(0).levels;
    ASSERT_EQ(levels.size(), 8U);
    for (std::size_t k = 1; k < levels.size(); ++k)
        EXPECT_NEAR(levels[k] - levels[k - 1], k == 3 || k == 5 ? 1.1 : k == 7 ? 1.05 : 1, 1e-9) << k;
}

TEST(Branches, WithFewRingsOrShortOnesStayAsTheyAre) {
    std::vector<std::uint32_t> of;
    const Branch few = branches(lone(2.4, 1, 50), {1, 0, false}, of).at(0);
    EXPECT_FALSE(few.closed);
    EXPECT_NEAR(few.off, 0.4, 1e-9);
    EXPECT_EQ(few.levels, (std::vector<double>{0.5, 1.5}));
    const Branch small = branches(lone(9.4, 1, 50), {1, 10, false}, of).at(0);
    EXPECT_FALSE(small.closed);
    EXPECT_EQ(small.off, 0);
    EXPECT_EQ(small.widest, 0);
}

TEST(Branches, MayEndAlongTheMaximum) {
    std::vector<std::uint32_t> of;
    EXPECT_NEAR(branches(lone(2.5, 1, 50), {1, 0, true}, of).at(0).levels.back(), 1.5, 1e-9);
    EXPECT_FALSE(branches(lone(2.5, 1, 50), {1, 0, false}, of).at(0).closed);
}

// Rings as long as circles about a point at the top: the innermost is as long as one of the radius.
TEST(Branches, AboutAPointEndWhereARingIsAsSmallAsMayBe) {
    auto isles = lone(12.2, 1, 0);
    for (Isle& i : isles) i.around = i.longest = 2 * 3.14159265358979 * (12.2 - i.ring - 0.5);
    std::vector<std::uint32_t> of;
    const Branch b = branches(isles, {1, 2.4, false}, of).at(0);
    EXPECT_TRUE(b.closed);
    double nearest = 1e9;
    for (const double l : b.levels) nearest = std::min(nearest, std::abs(l - (12.2 - 2.4)));
    EXPECT_LT(nearest, 1e-6);
}

std::vector<Isle> random_tree(std::mt19937& random, double spacing) {
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<Isle> out;
    std::vector<std::uint32_t> below{kNone};
    for (std::uint32_t ring = 0; !below.empty(); ++ring) {
        std::vector<std::uint32_t> now;
        for (const std::uint32_t outer : below) {
            const int parts = ring == 0 ? 2 : ring > 30 || unit() < 0.08 ? 0 : unit() < 0.15 ? 2 : 1;
            for (int k = 0; k < parts; ++k) {
                now.push_back(static_cast<std::uint32_t>(out.size()));
                const double around = 5 + 40 * unit();
                out.push_back({ring, outer, 0, around, 50, {}});
            }
        }
        below = now;
    }
    std::vector<char> has(out.size(), 0);
    for (std::size_t i = out.size(); i-- > 0;) {
        if (has[i] == 0) out[i].top = (out[i].ring + 0.5 + 0.01 + 0.98 * unit()) * spacing;
        if (out[i].outer == kNone) continue;
        has[out[i].outer] = 1;
        out[out[i].outer].top = std::max(out[out[i].outer].top, out[i].top);
    }
    return out;
}

TEST(Branches, OfRandomTreesKeepATenthCloseWhereTheyCanAndPartEvenly) {
    std::mt19937 random(4);
    std::size_t closed = 0, open = 0;
    for (int trial = 0; trial < trials(400); ++trial) {
        const double d = 0.4 + 0.01 * (random() % 100);
        const auto isles = random_tree(random, d);
        std::vector<std::uint32_t> of;
        const auto all = branches(isles, {d, 0, false}, of);
        std::vector<std::size_t> inner(isles.size(), 0);
        for (const Isle& i : isles)
            if (i.outer != kNone) ++inner[i.outer];
        for (std::uint32_t i = 0; i < isles.size(); ++i) ASSERT_LT(of[i], all.size());
        for (const Branch& b : all) {
            const double top = isles[b.last].top;
            for (std::size_t k = 1; k < b.levels.size(); ++k) {
                EXPECT_LE(b.levels[k] - b.levels[k - 1], 1.1 * d + 1e-9);
                EXPECT_GE(b.levels[k] - b.levels[k - 1], 0.9 * d - 1e-9);
            }
            if (b.closed) {
                EXPECT_NEAR(b.levels.back(), top - d / 2, 1e-9);
            }
            b.closed ? ++closed : ++open;
            // Five spacings that may change are enough for half of one: all but those in which branches part.
            std::size_t may = 0;
            for (std::uint32_t i = b.last; i != b.first; i = isles[i].outer) may += inner[isles[i].outer] == 1 ? 1 : 0;
            if (may >= 6) {
                EXPECT_TRUE(b.closed);
            }
            const std::uint32_t outer = isles[b.first].outer;
            if (outer == kNone || b.levels.empty()) continue;
            // The first ring is that of the branch that it leaves: there they may still be one line.
            const Branch& from = all[of[outer]];
            const std::size_t k = isles[b.first].ring - isles[from.first].ring;
            if (k < from.levels.size()) {
                EXPECT_NEAR(b.levels[0], from.levels[k], 1e-12);
            }
        }
    }
    EXPECT_GT(closed, 4 * trials(100));
    EXPECT_GT(open, 0U);
}

} // namespace
} // namespace filum::surfpath
