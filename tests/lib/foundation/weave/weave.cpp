#include "weave/weave.hpp"

#include "weave/join.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

namespace filum::weave {
namespace {

// Length of the parts of a trace, mm.
double length(const Trace& t) {
    double out = 0;
    for (const Step& s : t.steps) out += s.to - s.from;
    return out;
}

TEST(Weave, CurvesWithoutWindowsStayAsTheyWere) {
    const Weave w({3, 5});
    const auto all = w.traces();
    ASSERT_EQ(all.size(), 2U);
    for (const std::uint32_t k : {0U, 1U}) {
        EXPECT_TRUE(all[k].closed);
        ASSERT_EQ(all[k].steps.size(), 1U);
        EXPECT_EQ(all[k].steps[0].curve, k);
        EXPECT_EQ(length(all[k]), w.length(k));
        EXPECT_EQ(all[k].steps[0].link, kNone);
    }
}

TEST(Weave, AWindowIsFreeUnlessItOverlapsAnother) {
    Weave w({10});
    w.cut({0, 8, 11}); // over the first point
    EXPECT_TRUE(w.free({0, 1, 8}));
    EXPECT_TRUE(w.free({0, -9, -2})); // the same
    EXPECT_FALSE(w.free({0, 0.5, 2}));
    EXPECT_FALSE(w.free({0, 7, 8.5}));
    EXPECT_FALSE(w.free({0, 19, 19.5}));
    EXPECT_FALSE(w.free({0, 1, 12}));
    EXPECT_FALSE(Weave({10}).free({0, 0, 10})); // all of the curve
}

TEST(Weave, AnExchangeMakesOneClosedCurveOfTwo) {
    for (const bool same : {false, true}) {
        Weave w({10, 20});
        const auto links = w.exchange({0, 2, 3}, {1, 5, 7}, same);
        EXPECT_EQ(w.groups().sets(), 1U);
        const auto all = w.traces();
        ASSERT_EQ(all.size(), 1U);
        EXPECT_TRUE(all[0].closed);
        EXPECT_DOUBLE_EQ(length(all[0]), 9 + 18);
        ASSERT_EQ(all[0].steps.size(), 2U);
        EXPECT_EQ(all[0].steps[0].link, links[0]);
        EXPECT_FALSE(all[0].steps[0].link_backwards);
        EXPECT_EQ(all[0].steps[1].backwards, same); // curves that run alike are left against each other
        EXPECT_EQ(all[0].steps[1].link, links[1]);
        EXPECT_TRUE(all[0].steps[1].link_backwards);
    }
}

TEST(Weave, TailsAreTheEndsOfAnOpenCurve) {
    Weave w({10});
    const std::uint32_t window = w.cut({0, 2, 5});
    const std::uint32_t before = w.tail({window, false}), after = w.tail({window, true});
    const auto all = w.traces();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_FALSE(all[0].closed);
    EXPECT_EQ(all[0].tail, after);
    ASSERT_EQ(all[0].steps.size(), 1U);
    EXPECT_EQ(all[0].steps[0].from, 5);
    EXPECT_EQ(all[0].steps[0].to, 12);
    EXPECT_EQ(all[0].steps[0].link, before);
}

// Random windows and links, beside curves as chains of numbered ends: the traces use every part and every link once,
// follow only what is linked, and there are as many as the brute-force count.
TEST(Weave, TracesFollowTheLinksOfRandomCurves) {
    std::mt19937 random(1);
    for (int round = 0; round < 300; ++round) {
        const std::size_t n = 1 + random() % 6;
        Weave w(std::vector<double>(n, 10));
        std::vector<std::size_t> windows(n, 0); // per curve
        std::vector<End> ends;
        for (int k = 0; k < 12; ++k) {
            const double from = std::uniform_real_distribution<>(-20, 20)(random);
            const Window window{static_cast<std::uint32_t>(random() % n), from, from + 0.3};
            if (!w.free(window)) continue;
            const std::uint32_t number = w.cut(window);
            ++windows[window.curve];
            ends.push_back({number, false});
            ends.push_back({number, true});
        }
        std::shuffle(ends.begin(), ends.end(), random);
        std::size_t links = 0;
        for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
            if (random() % 5 == 0) continue; // two free ends
            if (random() % 5 == 0)
                w.tail(ends[k]);
            else
                w.link(ends[k], ends[k + 1]);
            ++links;
        }
        std::size_t parts = 0, used = 0;
        for (const std::size_t k : windows) parts += std::max<std::size_t>(1, k);
        std::vector<int> times(links, 0);
        bool open = true;
        double whole = 0;
        for (const Trace& t : w.traces()) {
            EXPECT_TRUE(open || t.closed); // open ones come first
            open = !t.closed;
            used += t.steps.size();
            whole += length(t);
            if (t.tail != kNone) ++times[t.tail];
            for (const Step& s : t.steps)
                if (s.link != kNone) ++times[s.link];
        }
        EXPECT_EQ(used, parts);
        EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](int k) { return k == 1; }));
        EXPECT_NEAR(whole, 10.0 * static_cast<double>(n) - 0.15 * static_cast<double>(ends.size()), 1e-9);
    }
}

TEST(Weave, JoiningTakesTheFirstSiteThatHasRoom) {
    struct Site {
        std::uint32_t a, b;
        bool room;
    };
    geom::DisjointSets groups(3);
    std::vector<std::size_t> made;
    const std::vector<Site> sites{{0, 1, false}, {0, 1, true}, {1, 0, true}, {2, 0, true}, {1, 2, true}};
    join(groups, sites, [&](const Site& s) {
        if (!s.room) return;
        made.push_back(static_cast<std::size_t>(&s - sites.data()));
        groups.unite(s.a, s.b);
    });
    EXPECT_EQ(made, (std::vector<std::size_t>{1, 3}));
}

TEST(Weave, TheCheapestSiteIsJudgedAgain) {
    std::priority_queue<int, std::vector<int>, std::greater<>> queue;
    for (const int cost : {1, 4, 5, 6}) queue.push(cost);
    std::vector<int> made;
    const auto judge = [](int& cost) {
        if (cost == 4) return Verdict::never;
        if (cost != 1) return Verdict::join;
        cost = 7; // dearer by now
        return Verdict::later;
    };
    join_cheapest(queue, judge, [&](int cost) { made.push_back(cost); });
    EXPECT_EQ(made, (std::vector<int>{5, 6, 7}));
}

} // namespace
} // namespace filum::weave
