// No more moves at a time than a controller takes, and the line that primes the nozzle.
#include "postproc/throughput.hpp"
#include "postproc/first_pass.hpp"

#include <gtest/gtest.h>
#include <random>

namespace filum::postproc {
namespace {

Step step(Act act, double feed, double length) {
    Step out;
    out.act = act;
    out.feed = feed;
    out.length = length;
    return out;
}

machine::Profile board(double per_second, int ahead) {
    machine::Profile out;
    out.motion.moves_per_second = per_second;
    out.motion.look_ahead = ahead;
    return out;
}

TEST(Throughput, NoGroupOfMovesIsQuickerThanTheBoardAndNoMoveIsSlowedForNothing) {
    std::mt19937 gen(5);
    for (const int ahead : {1, 4, 16}) {
        const auto p = board(200, ahead);
        const auto n = static_cast<std::size_t>(ahead);
        std::vector<Step> given, out;
        for (int k = 0; k < 20000; ++k) {
            if (gen() % 400 == 0) given.push_back(step(Act::travel, 150, 0));
            const double length = gen() % 3 == 0 ? 2 : 0.05;
            given.push_back(step(Act::extrude, 40, length));
        }
        Throughput t(p, [&](auto steps) { out.insert(out.end(), steps.begin(), steps.end()); });
        for (const Step& s : given) t.add(s);
        t.end();
        ASSERT_EQ(out.size(), given.size());
        std::vector<double> before, after; // since the last travel
        std::uint64_t slowed = 0;
        for (std::size_t i = 0; i < out.size(); ++i) {
            EXPECT_EQ(out[i].act, given[i].act);
            if (out[i].act != Act::extrude) {
                before.clear();
                after.clear();
                continue;
            }
            before.push_back(given[i].length / given[i].feed);
            after.push_back(out[i].length / out[i].feed);
            slowed += out[i].feed < given[i].feed ? 1 : 0;
            if (after.size() < n) continue;
            double sum = 0;
            for (std::size_t k = after.size() - n; k < after.size(); ++k) sum += after[k];
            EXPECT_GE(sum, static_cast<double>(n) / 200 * (1 - 1e-9));
        }
        EXPECT_GT(slowed, 100U);
        EXPECT_LE(slowed, t.slowed());
    }
    std::vector<double> slow(100, 0.1); // ten moves per second
    EXPECT_EQ(slow_down(slow, pace(board(200, 16))), 0U);
    EXPECT_EQ(pace(board(std::numeric_limits<double>::infinity(), 16)).seconds, 0);
}

TEST(PurgeLine, IsOnTheBedAndClearOfThePart) {
    const machine::Bed bed{0, 200, 0, 180, 0, 200};
    std::mt19937 gen(3);
    const auto uniform = [&](double low, double high) { return low + (high - low) * (gen() / 4294967296.0); };
    int lines = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec2 low{uniform(0, 150), uniform(0, 150)}, high{uniform(low.x, 200), uniform(low.y, 180)};
        const auto s = purge_line(bed, low, high);
        for (const Vec2 p : {s.a, s.b}) EXPECT_TRUE(p.x >= 0 && p.x <= 200 && p.y >= 0 && p.y <= 180);
        if (s.a == s.b) continue;
        ++lines;
        EXPECT_GE(geom::distance(s.a, s.b), 60 - 1e-9);
        EXPECT_TRUE(s.b.x < low.x || s.a.x > high.x || s.b.y < low.y || s.a.y > high.y);
    }
    EXPECT_GT(lines, 1000);
    const auto none = purge_line(bed, {0, 0}, {200, 180});
    EXPECT_EQ(none.a, none.b);
}

} // namespace
} // namespace filum::postproc
