#include "geom/nearest_points.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::geom {
namespace {

// Against asking every point, while points come and go; some lie on one place.
template <class V, class Place>
void expect_as_by_asking_every_one(const Place& place, std::mt19937& random) {
    for (int trial = 0; trial < 40; ++trial) {
        std::vector<V> points(1 + random() % 100);
        for (V& p : points) p = place();
        NearestPoints tree(points);
        std::vector<char> present(points.size(), 0);
        for (int step = 0; step < 300; ++step) {
            const auto i = static_cast<std::uint32_t>(random() % points.size());
            present[i] != 0 ? tree.remove(i) : tree.insert(i);
            present[i] = present[i] != 0 ? 0 : 1;
            const V p = place();
            std::optional<std::uint32_t> best;
            for (std::uint32_t k = 0; k < points.size(); ++k)
                if (present[k] != 0 && (!best || norm2(points[k] - p) < norm2(points[*best] - p))) best = k;
            EXPECT_EQ(tree.nearest(p), best);
            EXPECT_EQ(tree.empty(), !best);
        }
    }
}

TEST(NearestPoints, AgreeWithAskingEveryOne) {
    std::mt19937 random(2);
    const auto in_plane = [&] { return static_cast<double>(random() % 40); };
    expect_as_by_asking_every_one<Vec2>([&] { return Vec2{in_plane(), in_plane()}; }, random);
    const auto in_space = [&] { return static_cast<double>(random() % 8); };
    expect_as_by_asking_every_one<Vec3>([&] { return Vec3{in_space(), in_space(), in_space()}; }, random);
}

TEST(NearestPoints, OfNone) {
    EXPECT_TRUE(NearestPoints<Vec2>({}).empty());
    EXPECT_FALSE(NearestPoints<Vec3>({}).nearest({1, 2, 3}));
}

} // namespace
} // namespace filum::geom
