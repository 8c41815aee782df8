// Loops parted where they touch themselves, on small grids where everything touches everything.
#include "polygon/touches.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace filum::polygon;

namespace {

// Whether a loop comes to one of its points again.
bool repeats(std::span<const Vec2> loop) {
    std::set<std::pair<double, double>> seen;
    for (const Vec2 p : loop)
        if (!seen.emplace(p.x, p.y).second) return true;
    return false;
}

// A union of squares of a chessboard: corners touch.
Loops chessboard(std::mt19937& random, int side) {
    Loops squares;
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
            if (random() % 2 == 0)
                squares.add(
                    std::vector<Vec2>{{1.0 * x, 1.0 * y}, {x + 1.0, 1.0 * y}, {x + 1.0, y + 1.0}, {1.0 * x, y + 1.0}});
    return squares;
}

} // namespace

TEST(Touches, UnionsHaveNoLoopThatTouchesItself) {
    std::mt19937 random(3);
    for (int round = 0; round < 500; ++round) {
        const Loops squares = chessboard(random, 7), all = unite(squares);
        EXPECT_NEAR(signed_area(all), static_cast<double>(squares.size()), 1e-6) << round;
        for (std::size_t l = 0; l < all.size(); ++l) EXPECT_FALSE(repeats(all[l])) << round;
        double parts = 0;
        for (const Loops& part : split(all).part) {
            EXPECT_GT(signed_area(part), 0) << round;
            parts += signed_area(part);
        }
        EXPECT_NEAR(parts, signed_area(all), 1e-6) << round;
    }
}

TEST(Touches, LoopPartsAtItsVerticesAndAtItsEdges) {
    Loops eight; // two squares that share a corner
    eight.add(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}});
    EXPECT_EQ(parted_at_touches(eight).size(), 2U);
    Loops keyhole; // a notch whose tip lies on the opposite edge
    keyhole.add(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 3}, {3, 3}, {2, 0}, {1, 3}, {0, 3}});
    const Loops parted = parted_at_touches(keyhole);
    EXPECT_EQ(parted.size(), 2U);
    EXPECT_NEAR(signed_area(parted), signed_area(keyhole), 1e-9);
    Loops square;
    square.add(std::vector<Vec2>{{0, 0}, {4, 0}, {4, 4}, {0, 4}});
    EXPECT_EQ(parted_at_touches(square).points, square.points);
}
