#include "geom/box_tree.hpp"

#include <gtest/gtest.h>

#include <random>

namespace filum::geom {
namespace {

TEST(BoxTree, FindsEveryBoxThatMeetsAndNoOther) {
    std::mt19937 random(1);
    const auto place = [&] { return static_cast<double>(random() % 100); };
    for (const std::size_t n : {0, 1, 4, 5, 300}) {
        std::vector<Box3> boxes;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 lo{place(), place(), place()};
            boxes.push_back({lo, lo + 0.1 * Vec3{place(), place(), place()}});
        }
        const BoxTree tree(boxes);
        for (int k = 0; k < 50; ++k) {
            const Vec3 lo{place(), place(), place()};
            const Box3 asked{lo, lo + Vec3{10, 20, 5}};
            std::vector<int> seen(n, 0);
            tree.visit(asked, [&](std::uint32_t i) { ++seen[i]; });
            for (std::size_t i = 0; i < n; ++i) EXPECT_EQ(seen[i], meet(boxes[i], asked) ? 1 : 0);
        }
    }
}

} // namespace
} // namespace filum::geom
