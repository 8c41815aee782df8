#include "surfpath/plan/improve.hpp"

#include "../../../trials.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

namespace filum::surfpath::plan {

namespace {

constexpr double kDear = 20;

// Rows one apart, turns of `least` rows and up to three more that are good, dear ones to the next two.
std::vector<Link> turns(std::uint32_t rows, std::uint32_t least) {
    std::vector<Link> out;
    for (std::uint32_t a = 0; a < rows; ++a)
        for (std::uint32_t jump = 1; jump <= least + 3 && a + jump < rows; ++jump) {
            if (jump > 2 && jump < least) continue;
            for (std::uint32_t side = 0; side < 2; ++side)
                out.push_back({2 * a + side, 2 * (a + jump) + side, jump < least ? 2 * kDear : 1.0 * jump});
        }
    return out;
}

struct Figures {
    double cost = 0;
    std::size_t dear = 0;
};

// Of the chains; fails if they leave out a row, pass one twice, or turn where there is no link.
Figures figures(std::uint32_t rows, const std::vector<Link>& links, double breaks,
                const std::vector<std::vector<Visit>>& chains) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> cost;
    for (const Link& l : links) cost[{l.from, l.to}] = l.cost;
    Figures out;
    std::vector<int> passed(rows, 0);
    const auto in = [](const Visit& v) { return 2 * v.row + (v.reversed ? 1U : 0U); };
    for (const auto& chain : chains) {
        out.cost += breaks;
        for (std::size_t i = 0; i < chain.size(); ++i) {
            ++passed[chain[i].row];
            if (i == 0) continue;
            const std::uint32_t from = in(chain[i - 1]) ^ 1U, to = in(chain[i]);
            const auto link = cost.find({std::min(from, to), std::max(from, to)});
            EXPECT_TRUE(link != cost.end());
            out.cost += link->second;
            out.dear += link->second >= kDear ? 1 : 0;
        }
    }
    EXPECT_EQ(std::count(passed.begin(), passed.end(), 1), rows);
    return out;
}

// What a search finds that keeps ten states only, a dear turn or two of it, becomes as good as what one finds that
// keeps very many.
TEST(Improve, RidsOrdersOfDearTurns) {
    std::size_t before = 0, after = 0, wide = 0;
    for (std::uint32_t rows = 24; rows <= 80; rows += kSanitized ? 24 : 8)
        for (const std::uint32_t least : {4U, 5U, 6U}) {
            const auto links = turns(rows, least);
            const Costs costs{200, 0};
            const auto first = order(rows, links, costs, 10);
            const auto better = improved(rows, links, costs, kDear, first);
            const Figures a = figures(rows, links, 200, first), b = figures(rows, links, 200, better);
            EXPECT_LE(b.cost, a.cost);
            before += a.dear;
            after += b.dear;
            wide += figures(rows, links, 200, order(rows, links, costs, 3000)).dear;
        }
    EXPECT_GT(before, kSanitized ? 5U : 15U);
    EXPECT_LE(after, wide);
    EXPECT_LT(3 * after, before);
}

// Against all orders of a few rows, with links as they come.
TEST(Improve, CostsNoMoreAndOftenTheLeast) {
    std::size_t best = 0, all = 0;
    for (std::uint32_t seed = 1; seed <= 60; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> cost(1, 60);
        const std::uint32_t rows = 7;
        std::vector<Link> links;
        for (std::uint32_t a = 0; a < 2 * rows; ++a)
            for (std::uint32_t b = a + 1; b < 2 * rows; ++b)
                if (a / 2 != b / 2 && random() % 2 == 0) links.push_back({a, b, cost(random)});
        const Costs costs{100, 0};
        const auto first = order(rows, links, costs, 1);
        const double given = figures(rows, links, 100, first).cost;
        const double now = figures(rows, links, 100, improved(rows, links, costs, kDear, first)).cost;
        const double least = figures(rows, links, 100, order(rows, links, costs, 1'000'000)).cost;
        EXPECT_LE(now, given + 1e-9) << seed;
        EXPECT_GE(now, least - 1e-9) << seed;
        ++all;
        best += now < least + 1e-9 ? 1 : 0;
    }
    EXPECT_GT(3 * best, all);
}

TEST(Improve, LeavesWhatIsNotDear) {
    const std::vector<Link> links{{0, 2, 1}, {1, 3, 1}};
    const auto chains = order(2, links, {10, 0}, 10);
    const auto same = improved(2, links, {10, 0}, kDear, chains);
    ASSERT_EQ(same.size(), 1U);
    EXPECT_EQ(same[0][0].row, chains[0][0].row);
    EXPECT_TRUE(improved(0, {}, {10, 0}, kDear, {}).empty());
}

} // namespace

} // namespace filum::surfpath::plan
