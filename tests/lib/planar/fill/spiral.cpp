#include "fill/spiral.hpp"
#include "fill/join/crossings.hpp"

#include "geom/segment_grid.hpp"
#include "shapes.hpp"

#include <gtest/gtest.h>

namespace filum {
namespace {

using fill::Spiral;
using geom::Vec2;
using polygon::Loops;
using test::kWidth;

Spiral fill_it(const Loops& region, double width = kWidth) {
    Notes notes;
    return fill::spiral(region, {.bead_width = width}, notes);
}

double deposited(const Spiral& s) { // mm2 of beads, overlaps counted twice
    double sum = 0;
    for (const auto& c : s.curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const std::size_t j = (i + 1) % c.points.size();
            sum += geom::distance(c.points[i], c.points[j]) * (c.width[i] + c.width[j]) / 2;
        }
    return sum;
}

// Share of the region within a bead, by `n` random points: good to about 1 / sqrt(n) of what is missing.
double coverage(const Loops& region, const Spiral& s, int n = 4000) {
    std::vector<geom::Segment> segments;
    std::vector<double> width;
    for (const auto& c : s.curves)
        for (std::size_t i = 0; i < c.points.size(); ++i) {
            const std::size_t j = (i + 1) % c.points.size();
            segments.push_back({c.points[i], c.points[j]});
            width.push_back((c.width[i] + c.width[j]) / 2);
        }
    const geom::SegmentGrid grid(segments, 1);
    const auto box = polygon::bounds(region);
    std::mt19937 random(1);
    const auto uniform = [&](double a, double b) { return a + (b - a) * (random() / 4294967296.0); };
    int in = 0, covered = 0;
    while (in < n) {
        const Vec2 p{uniform(box.lo.x, box.hi.x), uniform(box.lo.y, box.hi.y)};
        if (!polygon::contains(region, p)) continue;
        ++in;
        bool hit = false;
        grid.near({p.x - 1, p.y - 1}, {p.x + 1, p.y + 1}, [&](std::uint32_t k) {
            hit = hit || geom::point_segment_distance(segments[k].a, segments[k].b, p) <= width[k] / 2;
        });
        covered += hit ? 1 : 0;
    }
    return static_cast<double>(covered) / in;
}

void expect_one_clean_curve(const Loops& region, const Spiral& s) {
    ASSERT_EQ(s.curves.size(), 1U);
    EXPECT_TRUE(s.curves[0].closed);
    EXPECT_EQ(fill::join::crossing_pairs(s.curves, kWidth).size(), 0U);
    for (const Vec2 p : s.curves[0].points) {
        bool inside = polygon::contains(region, p);
        for (std::size_t l = 0; l < region.size() && !inside; ++l)
            for (std::size_t i = 0; i < region[l].size() && !inside; ++i)
                inside = geom::point_segment_distance(region[l][i], region[l][(i + 1) % region[l].size()], p) < 0.013;
        EXPECT_TRUE(inside) << p.x << ',' << p.y;
    }
}

class RandomRegion : public testing::TestWithParam<std::uint32_t> {};

TEST_P(RandomRegion, IsFilledByOneClosedCurveThatDoesNotCrossItself) {
    const Loops region = test::random_region(GetParam());
    const Spiral s = fill_it(region);
    expect_one_clean_curve(region, s);
    EXPECT_GT(coverage(region, s), 0.95);
    EXPECT_NEAR(deposited(s), polygon::signed_area(region), 0.06 * polygon::signed_area(region));
}

INSTANTIATE_TEST_SUITE_P(Spiral, RandomRegion, testing::Range(1U, 60U));

TEST(Spiral, FillsTheBarOfThePaperAlmostWholly) {
    const Loops bar = test::rectangle(0, 0, 100, 25);
    const Spiral s = fill_it(bar);
    expect_one_clean_curve(bar, s);
    EXPECT_GT(coverage(bar, s), 0.995);
    EXPECT_NEAR(deposited(s), 2500, 0.01 * 2500);
}

// F2: the erosion by half a bead falls into two parts.
TEST(Spiral, GoesThroughNecksThinnerThanABead) {
    for (const double neck : {0.39, 0.3, 0.2, 0.1, 0.05}) {
        const Loops region = test::dumbbell(neck);
        const Spiral s = fill_it(region);
        expect_one_clean_curve(region, s);
        EXPECT_GT(coverage(region, s), 0.97) << neck;
    }
}

// F3: no erosion at all.
TEST(Spiral, LaysTwoLanesInAWallThinnerThanABead) {
    for (const double wall : {0.5, 0.4, 0.35, 0.2, 0.08}) {
        const Loops region = test::rectangle(0, 0, 20, wall);
        const Spiral s = fill_it(region);
        expect_one_clean_curve(region, s);
        EXPECT_GT(coverage(region, s), 0.95) << wall;
        EXPECT_NEAR(deposited(s), 20 * wall, 0.08 * 20 * wall) << wall;
    }
}

// F1: a wall of any thickness is shared evenly.
TEST(Spiral, FillsWallsOfEveryThickness) {
    for (double wall = 0.4; wall < 4; wall += 0.13) {
        const Loops region = test::rectangle(0, 0, 30, wall);
        const Spiral s = fill_it(region);
        expect_one_clean_curve(region, s);
        EXPECT_GT(coverage(region, s), 0.96) << wall;
    }
}

TEST(Spiral, FollowsTapersAndHoles) {
    for (const Loops& region : {test::comb(5, 6), test::sieve(4, 1.0, 0.35), test::sieve(3, 0.7, 0.9)}) {
        const Spiral s = fill_it(region);
        expect_one_clean_curve(region, s);
        EXPECT_GT(coverage(region, s), 0.95);
    }
}

TEST(Spiral, GivesSpecksARing) {
    for (const double r : {0.3, 0.1, 0.03}) {
        const Spiral s = fill_it(test::disc({5, 5}, r));
        ASSERT_EQ(s.curves.size(), 1U) << r;
        EXPECT_GT(deposited(s), 0);
    }
}

TEST(Spiral, DoesNotDependOnWhereTheRegionLies) {
    const Loops here = test::random_region(7);
    Loops there = here;
    for (Vec2& p : there.points) p = p + Vec2{1024, -2048};
    const Spiral a = fill_it(here), b = fill_it(there);
    ASSERT_EQ(a.curves.size(), b.curves.size());
    EXPECT_NEAR(deposited(a), deposited(b), 1e-3 * deposited(a));
}

TEST(Spiral, ReportsBeadsBelowTheLeastWidth) {
    Notes notes;
    fill::spiral(test::rectangle(0, 0, 10, 0.1), {.bead_width = kWidth, .min_width = 0.1}, notes);
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].code, NoteCode::bead_too_thin);
    EXPECT_GT(notes[0].amount, 15);
}

TEST(Crossings, AreCounted) {
    toolpath::Curve eight{true, {{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {0.4}};
    EXPECT_EQ(fill::join::crossing_pairs({eight}, 0.4).size(), 1U);
}

} // namespace
} // namespace filum
