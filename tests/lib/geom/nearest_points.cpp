#include "geom/nearest_points.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::geom {
namespace {

// Against asking every point, while points come and go; some lie on one place.
TEST(NearestPoints, AgreeWithAskingEveryOne) {
    std::mt19937 random(2);
    const auto uniform = [&] { return static_cast<double>(random() % 40); };
    for (int trial = 0; trial < 40; ++trial) {
        std::vector<Vec2> points(1 + random() % 100);
        for (Vec2& p : points) p = {uniform(), uniform()};
        NearestPoints tree(points);
        std::vector<char> present(points.size(), 0);
        for (int step = 0; step < 300; ++step) {
            const auto i = static_cast<std::uint32_t>(random() % points.size());
            present[i] != 0 ? tree.remove(i) : tree.insert(i);
            present[i] = present[i] != 0 ? 0 : 1;
            const Vec2 p{uniform(), uniform()};
            std::optional<std::uint32_t> best;
            for (std::uint32_t k = 0; k < points.size(); ++k)
                if (present[k] != 0 && (!best || norm2(points[k] - p) < norm2(points[*best] - p))) best = k;
            EXPECT_EQ(tree.nearest(p), best);
            EXPECT_EQ(tree.empty(), !best);
        }
    }
}

TEST(NearestPoints, OfNone) {
    EXPECT_TRUE(NearestPoints({}).empty());
    EXPECT_FALSE(NearestPoints({}).nearest({1, 2}));
}

} // namespace
} // namespace filum::geom
