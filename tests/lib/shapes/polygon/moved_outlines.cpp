// Offsets by outlines of their own: where they lie, and how many points they have.
#include "polygon/clip.hpp"

#include "geom/segment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace filum::polygon {
namespace {

// A closed line around the origin with slight and sharp bends; clockwise ones are holes.
void add_wave(Loops& out, double radius, double depth, std::size_t points, bool hole) {
    std::vector<Vec2> loop;
    for (std::size_t i = 0; i < points; ++i) {
        const double angle =
            (hole ? -1 : 1) * 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
        const double r = radius + depth * std::sin(7 * angle);
        loop.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    out.add(loop);
}

double way_to(const Loops& a, Vec2 p) {
    double best = 1e300;
    for (std::size_t l = 0; l < a.size(); ++l)
        for (std::size_t k = 0; k < a[l].size(); ++k)
            best = std::min(best, geom::point_segment_distance(a[l][k], a[l][(k + 1) % a[l].size()], p));
    return best;
}

// A point lies in the offset if its distance from the area is at most the offset. Points nearer to its outline than the
// tolerance of arcs may lie on either side.
TEST(MovedOutlines, TheOffsetHoldsWhatTheDistanceSays) {
    constexpr double kArcs = 0.01;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-14, 14);
    for (const std::size_t points : {7U, 40U, 400U})
        for (const double depth : {0.0, 0.7, 2.5}) {
            Loops ring;
            add_wave(ring, 10, depth, points, false);
            add_wave(ring, 5, depth / 2, points, true);
            const Loops area = unite(ring);
            for (const double delta : {-1.5, -0.2, -0.003, 0.003, 0.2, 1.5}) {
                const Loops moved = offset(area, delta, kArcs);
                for (int k = 0; k < 300; ++k) {
                    const Vec2 p{unit(random), unit(random)};
                    const double beyond = (contains(area, p) ? -1 : 1) * way_to(area, p) - delta;
                    if (std::abs(beyond) <= kArcs + 1e-3) continue;
                    EXPECT_EQ(contains(moved, p), beyond < 0) << points << " " << depth << " " << delta;
                }
            }
        }
}

// Openings of a smooth outline have no more points than the outline, however many follow each other.
TEST(MovedOutlines, SmoothOutlinesGetNoMorePoints) {
    Loops smooth;
    add_wave(smooth, 10, 0.7, 400, false);
    Loops moved = smooth;
    for (int k = 0; k < 6; ++k) {
        moved = opened(moved, 0.3, 0.01);
        EXPECT_LE(moved.points.size(), smooth.points.size());
        EXPECT_NEAR(signed_area(moved), signed_area(smooth), 0.02);
    }
}

} // namespace
} // namespace filum::polygon
