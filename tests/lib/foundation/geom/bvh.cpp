#include "geom/bvh.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::geom {
namespace {

TEST(Bvh, FindsEveryBoxThatMeetsAndNoOther) {
    std::mt19937 random(1);
    const auto place = [&] { return static_cast<double>(random() % 100); };
    for (const std::size_t n : {0, 1, 4, 5, 300}) {
        std::vector<Box3> boxes;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 lo{place(), place(), place()};
            boxes.push_back({lo, lo + 0.1 * Vec3{place(), place(), place()}});
        }
        const Bvh tree(boxes);
        for (int k = 0; k < 50; ++k) {
            const Vec3 lo{place(), place(), place()};
            const Box3 asked{lo, lo + Vec3{10, 20, 5}};
            std::vector<int> seen(n, 0);
            tree.visit(asked, [&](std::uint32_t i) { ++seen[i]; });
            for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(seen[i], meet(boxes[i], asked) ? 1 : 0);
        }
    }
}

TEST(Bvh, FindsTheBoxesWithinABoundThatShrinks) {
    std::mt19937 random(2);
    const auto place = [&] { return static_cast<double>(random() % 100); };
    for (const std::size_t n : {0, 1, 5, 300}) {
        std::vector<Box3> boxes;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 lo{place(), place(), place()};
            boxes.push_back({lo, lo + 0.05 * Vec3{place(), place(), place()}});
        }
        const Bvh tree(boxes);
        for (int k = 0; k < 50; ++k) {
            const Vec3 p{place(), place(), place()};
            std::vector<int> seen(n, 0);
            tree.near(p, 20, [&](std::uint32_t i) { return ++seen[i], 20.0; });
            double least = 1e300, found = 1e300;
            for (std::size_t i = 0; i < n; ++i) {
                EXPECT_EQ(seen[i], distance(boxes[i], p) <= 20 ? 1 : 0);
                least = std::min(least, distance(boxes[i], p));
            }
            tree.near(p, 1e300, [&](std::uint32_t i) { return found = std::min(found, distance(boxes[i], p)); });
            EXPECT_EQ(found, least);
        }
    }
}

} // namespace
} // namespace filum::geom
