// Cluster by cluster gives what one piece gives, for outlines within and across each other.
#include "polygon/clusters.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace filum::polygon;

namespace {

void add_ring(Loops& out, Vec2 at, double r, int corners, double turned, bool hole) {
    for (int i = 0; i < corners; ++i) {
        const double a = (hole ? -1 : 1) * 2 * std::numbers::pi * i / corners + turned;
        out.points.push_back({at.x + r * std::cos(a), at.y + r * std::sin(a)});
    }
    out.close();
}

// Concentric tubes in several places, with islands in the innermost one.
Loops tubes(std::mt19937& random, Vec2 shift, double turned) {
    const auto any = [&](double from, double to) { return std::uniform_real_distribution(from, to)(random); };
    Loops out;
    for (int x = 0; x < 2; ++x)
        for (int y = 0; y < 2; ++y) {
            const Vec2 at = Vec2{60.0 * x, 60.0 * y} + shift;
            const int corners = 30 + static_cast<int>(random() % 30);
            double r = 28;
            for (; r > 5; r -= 2.5) {
                const double wall = any(0.5, 1.2);
                add_ring(out, at, r, corners, turned, false);
                add_ring(out, at, r - wall, corners, turned, true);
            }
            add_ring(out, at + Vec2{any(-1, 1), any(-1, 1)}, any(0.5, 1.5), corners, turned, false);
        }
    return out;
}

double difference(const Loops& a, const Loops& b) { return signed_area(subtract(a, b)) + signed_area(subtract(b, a)); }

} // namespace

TEST(Clustered, TubesAreCombinedAsInOnePiece) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed), again(seed);
        const double far = seed % 4; // mm: not at all, within a wall, across tubes
        const Loops in[] = {tubes(random, {0, 0}, 0), tubes(again, {0.4 * far, 0.1 * far}, 0.3)};
        ASSERT_GT(in[0].points.size() + in[1].points.size(), 2000U);
        for (const bool common : {true, false}) {
            std::size_t most = 0, calls = 0;
            const auto operation = [&](std::span<const Loops> part) {
                most = std::max(most, part[0].points.size() + part[1].points.size());
                ++calls;
                return common ? intersect(part[0], part[1]) : subtract(part[0], part[1]);
            };
            const Loops apart = clustered(in, 0.001, operation);
            // Each place has too few points for clusters, so its operation is done in one piece.
            double whole = 0;
            for (const double x : {-30.0, 30.0})
                for (const double y : {-30.0, 30.0}) {
                    const Box2 box{{x, y}, {x + 60, y + 60}};
                    const Loops part[] = {within_box(in[0], box), within_box(in[1], box)};
                    whole += signed_area(common ? intersect(part[0], part[1]) : subtract(part[0], part[1]));
                }
            EXPECT_GE(calls, 4U) << seed;
            EXPECT_TRUE(is_simple(apart)) << seed;
            EXPECT_NEAR(signed_area(apart), whole, 0.01) << seed;
        }
    }
}

TEST(Clustered, OffsetsOfTubesMeetAsInOnePiece) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        std::mt19937 random(seed);
        const Loops in = tubes(random, {0, 0}, 0);
        for (const double delta : {-0.3, -0.1, 0.1, 0.5, 1.0}) {
            const Loops apart = clustered({&in, 1}, 2 * std::abs(delta) + 0.01,
                                          [&](std::span<const Loops> part) { return offset(part[0], delta, 0.002); });
            Loops whole;
            for (int x = 0; x < 2; ++x)
                for (int y = 0; y < 2; ++y)
                    whole.add(
                        offset(within_box(in, {{60.0 * x - 29.5, 60.0 * y - 29.5}, {60.0 * x + 29.5, 60.0 * y + 29.5}}),
                               delta, 0.002));
            EXPECT_TRUE(is_simple(apart)) << seed << " " << delta;
            EXPECT_LT(difference(apart, whole), 0.01) << seed << " " << delta;
        }
    }
}
