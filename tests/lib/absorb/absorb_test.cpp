#include "absorb/absorb.hpp"

#include "geom/segment_grid.hpp"
#include "polygon/segments.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace filum {
namespace {

using geom::Vec2;
using polygon::Loops;
using toolpath::Curve;

constexpr double kWidth = 0.4;

struct Amount { // shares of the region's area
    double covered = 0, outside = 0, laid = 0;
};

// By points on a grid of a thirtieth of a bead width.
Amount measure(const Loops& region, const std::vector<Curve>& curves) {
    std::vector<geom::Segment> segments;
    std::vector<double> half;
    Amount out;
    for (const Curve& c : curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const std::size_t j = (i + 1) % c.points.size();
            segments.push_back({c.points[i], c.points[j]});
            half.push_back((c.width[i] + c.width[j]) / 4);
            out.laid += 2 * half.back() * geom::distance(c.points[i], c.points[j]);
        }
    const geom::SegmentGrid grid(segments, kWidth);
    const auto box = polygon::bounds(region);
    const double step = kWidth / 30.3;
    double inside = 0;
    for (double y = box.lo.y - kWidth; y < box.hi.y + kWidth; y += step)
        for (double x = box.lo.x - kWidth; x < box.hi.x + kWidth; x += step) {
            bool hit = false;
            grid.near({x - kWidth, y - kWidth}, {x + kWidth, y + kWidth}, [&](std::uint32_t k) {
                hit = hit || geom::point_segment_distance(segments[k].a, segments[k].b, {x, y}) <= half[k];
            });
            const bool within = polygon::contains(region, {x, y});
            inside += within ? 1 : 0;
            if (hit) (within ? out.covered : out.outside) += 1;
        }
    out.covered /= inside, out.outside /= inside, out.laid /= polygon::signed_area(region);
    return out;
}

bool crosses(const std::vector<Curve>& curves) {
    std::vector<geom::Segment> s;
    for (const Curve& c : curves)
        for (std::size_t i = 0; i < c.points.size(); ++i)
            s.push_back({c.points[i], c.points[(i + 1) % c.points.size()]});
    for (std::size_t i = 0; i < s.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (geom::cross_properly(s[i].a, s[i].b, s[j].a, s[j].b)) return true;
    return false;
}

// A polygon about the origin and the ring that a bead would follow half a width inside, if its corners allow.
struct Ring {
    Loops region;
    std::vector<Curve> curve;
};
Ring ring(const std::vector<Vec2>& corners) {
    Ring out;
    out.region.add(corners);
    Curve c{true, {}, {}};
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 u = corners[i] - corners[(i + n - 1) % n], v = corners[(i + 1) % n] - corners[i];
        const Vec2 a = (1 / geom::norm(u)) * geom::left_of(u), b = (1 / geom::norm(v)) * geom::left_of(v);
        const Vec2 p = corners[i] + (kWidth / 2 * 2 / geom::norm2(a + b)) * (a + b);
        c.points.push_back({std::round(p.x * 1e3) / 1e3, std::round(p.y * 1e3) / 1e3});
        c.width.push_back(kWidth);
    }
    out.curve.push_back(std::move(c));
    return out;
}

void expect_better(const Ring& r, const char* what) {
    const auto improved = absorb::absorb(r.region, r.curve, {.bead_width = kWidth});
    ASSERT_EQ(improved.size(), 1U);
    EXPECT_TRUE(improved[0].closed);
    ASSERT_EQ(improved[0].points.size(), improved[0].width.size());
    EXPECT_FALSE(crosses(improved)) << what;
    const Amount before = measure(r.region, r.curve), after = measure(r.region, improved);
    EXPECT_GE(after.covered, before.covered - 0.001) << what;
    EXPECT_LE(after.outside, before.outside + 0.015) << what;
    EXPECT_LE(after.laid, before.laid + 0.16) << what;
    for (const double w : improved[0].width) EXPECT_GT(w, 0.1 * kWidth) << what;
}

TEST(Absorb, NeverCoversLessNorCrosses) {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> length(1.5, 5), slant(-0.9, 0.9), turn(0, 6);
    for (int run = 0; run < 40; ++run) { // walls of two lanes, with ends cut square or to acute corners
        const double l = length(random), a = turn(random), c = std::cos(a), s = std::sin(a);
        const double p = run % 4 == 0 ? 0 : slant(random), q = run % 4 == 0 ? 0 : slant(random);
        std::vector<Vec2> corners;
        for (const Vec2 v : {Vec2{0, 0}, {l, 0}, {l + p, 2 * kWidth}, {q, 2 * kWidth}})
            corners.push_back({c * v.x - s * v.y, s * v.x + c * v.y});
        expect_better(ring(corners), ("run " + std::to_string(run)).c_str());
    }
}

// The void beside a right angle is (1 - pi/4) / 4 of a bead width squared; two narrow lanes cover most of it.
TEST(Absorb, ReachesIntoTheCornersOfAShortWall) {
    const Ring r = ring({{0, 0}, {3, 0}, {3, 0.8}, {0, 0.8}});
    const double bare = 4 * (1 - std::numbers::pi / 4) / 4 * kWidth * kWidth / (3 * 0.8);
    const Amount before = measure(r.region, r.curve);
    EXPECT_NEAR(before.covered, 1 - bare, 0.002);
    const Amount after = measure(r.region, absorb::absorb(r.region, r.curve, {.bead_width = kWidth}));
    EXPECT_GT(after.covered, 1 - 0.5 * bare);
}

// Two lanes with a slit of a twentieth of a bead width between them, and one to the outline.
TEST(Absorb, ClosesSlitsByWideningTheLanes) {
    Ring r;
    r.region.add(std::vector<Vec2>{{0, 0}, {10, 0}, {10, 0.83}, {0, 0.83}});
    r.curve.push_back({true, {{0.2, 0.2}, {9.8, 0.2}, {9.8, 0.63}, {0.2, 0.63}}, {0.39, 0.39, 0.39, 0.39}});
    const Amount before = measure(r.region, r.curve);
    const Amount after = measure(r.region, absorb::absorb(r.region, r.curve, {.bead_width = kWidth}));
    EXPECT_LT(before.covered, 0.94);
    EXPECT_GT(after.covered, 0.97);
}

TEST(Absorb, LeavesNothingAsItIs) {
    EXPECT_TRUE(absorb::absorb({}, {}, {}).empty());
    const Ring r = ring({{0, 0}, {3, 0}, {3, 3}, {0, 3}});
    EXPECT_TRUE(absorb::absorb(r.region, {}, {}).empty());
}

TEST(Absorb, GivesTheSameEveryTime) {
    const Ring r = ring({{0, 0}, {4, 0}, {3, 1.5}, {0.2, 2}});
    const auto a = absorb::absorb(r.region, r.curve, {.bead_width = kWidth});
    const auto b = absorb::absorb(r.region, r.curve, {.bead_width = kWidth});
    EXPECT_EQ(a[0].points, b[0].points);
    EXPECT_EQ(a[0].width, b[0].width);
}

} // namespace
} // namespace filum
