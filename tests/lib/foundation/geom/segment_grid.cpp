#include "geom/segment_grid.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace {

using namespace filum::geom;

std::vector<Segment> random_segments(std::mt19937& random, double longest) {
    const auto uniform = [&](double hi) { return hi * static_cast<double>(random()) / 4294967296.0; };
    std::vector<Segment> out;
    for (int k = 0; k < 60; ++k) {
        const Vec2 a{uniform(20), uniform(20)};
        const double length = k < 3 ? longest : 1, turn = uniform(6.3);
        out.push_back({a, {a.x + length * std::cos(turn), a.y + (k == 0 ? 0 : length * std::sin(turn))}});
    }
    return out;
}

TEST(SegmentGrid, FindsAllThatIsNearWhateverTheLengths) {
    std::mt19937 random(1);
    for (const double longest : {1.0, 1e3, 1e5, 1e8})
        for (const double margin : {0.0, 0.4, 30.0}) {
            const auto segments = random_segments(random, longest);
            const SegmentGrid grid(segments, 0.4, margin);
            EXPECT_LT(grid.cells(), 16e6) << longest; // 36 bytes each
            for (const Segment& s : segments) {
                std::set<std::uint32_t> found;
                grid.near(s.a, s.a, [&](std::uint32_t i) { found.insert(i); });
                for (std::uint32_t i = 0; i < segments.size(); ++i) {
                    const bool near = point_segment_distance(segments[i].a, segments[i].b, s.a) <= margin;
                    EXPECT_TRUE(!near || found.contains(i));
                }
            }
        }
}

TEST(SegmentGrid, OneLongSegmentTakesBoundedMemory) {
    const std::vector<Segment> one{{{0, 0}, {1e8, 0}}, {{0, 0}, {1, 1}}};
    EXPECT_LT(SegmentGrid(one, 0.4, 0.4).cells(), 16e6);
}

// Each pair of segments that is found while they are added is found once, and no pair that is near is missing.
TEST(SegmentPairs, FindsEveryNearPairOnce) {
    std::mt19937 random(2);
    for (const double longest : {1.0, 1e3, 1e8})
        for (const double margin : {0.0, 0.4}) {
            const auto segments = random_segments(random, longest);
            SegmentPairs pairs(segments, 0.4, margin);
            std::set<std::pair<std::uint32_t, std::uint32_t>> found;
            for (std::uint32_t k = 0; k < segments.size(); ++k) {
                pairs.add(k, [&](std::uint32_t i) { EXPECT_TRUE(i < k && found.emplace(i, k).second); });
                std::set<std::uint32_t> along;
                pairs.along(segments[k].a, segments[k].b, [&](std::uint32_t i) { along.insert(i); });
                for (std::uint32_t i = 0; i <= k; ++i) {
                    const Segment &s = segments[i], &t = segments[k];
                    const double apart = segment_distance(s.a, s.b, t.a, t.b);
                    EXPECT_TRUE(i == k || apart > margin || found.contains({i, k})) << i << " " << k;
                    EXPECT_TRUE(apart > margin || along.contains(i)) << i << " " << k;
                }
            }
        }
}

// Pairs with a marked segment are found once, as all others are not; none that is near is missing.
TEST(MarkedSegments, FindEveryNearPairOfTheirsOnce) {
    std::mt19937 random(3);
    for (const double longest : {1.0, 1e3, 1e8})
        for (const double margin : {0.0, 0.4})
            for (const unsigned rare : {1U, 4U, 1000U}) {
                const auto segments = random_segments(random, longest);
                std::vector<char> marked;
                for (std::size_t i = 0; i < segments.size(); ++i) marked.push_back(random() % rare == 0 ? 1 : 0);
                const MarkedSegments some(segments, marked, 0.4, margin);
                std::set<std::pair<std::uint32_t, std::uint32_t>> found;
                some.pairs([&](std::uint32_t i, std::uint32_t k) {
                    EXPECT_TRUE(i < k && (marked[i] != 0 || marked[k] != 0) && found.emplace(i, k).second);
                });
                for (std::uint32_t k = 0; k < segments.size(); ++k) {
                    std::set<std::uint32_t> along;
                    some.along(segments[k].a, segments[k].b, [&](std::uint32_t i) {
                        EXPECT_TRUE(marked[i] != 0);
                        along.insert(i);
                    });
                    for (std::uint32_t i = 0; i < segments.size(); ++i) {
                        const Segment &s = segments[i], &t = segments[k];
                        const bool near = segment_distance(s.a, s.b, t.a, t.b) <= margin;
                        const bool any = marked[i] != 0 || marked[k] != 0;
                        EXPECT_TRUE(i >= k || !near || !any || found.contains({i, k})) << i << " " << k;
                        EXPECT_TRUE(!near || marked[i] == 0 || along.contains(i)) << i << " " << k;
                    }
                }
            }
}

} // namespace
