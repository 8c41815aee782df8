// Where the construction of the 2019 paper fails, and the default does not: a test per failure mode.
//
// Each test measures one property on both.  That the baseline violates it is asserted, too: it is what the mode is.
// F11 to F13, of the sequence and of the links between layers and parts, are in tests/bats/failure-modes.bats.
#include "../../fill/pattern_check.hpp"
#include "baselines/sun2019/contour_graph.hpp"
#include "baselines/sun2019/spiral.hpp"
#include "fill/spiral.hpp"

#include <algorithm>

namespace filum::baselines::sun2019 {
namespace {

using namespace test;

constexpr double kBead = 0.4; // mm, everywhere here

std::vector<Curve> baseline(const Loops& region, const SpiralOptions& o = {}) {
    Notes notes;
    return spiral(region, o, notes);
}

std::vector<Curve> by_default(const Loops& region) {
    Notes notes;
    return fill::spiral(region, {.bead_width = kBead}, notes).curves;
}

double material(const Loops& region, const std::vector<Curve>& curves) {
    return laid(curves) / polygon::signed_area(region);
}

Loops annulus(double outer, double wall) { // mm
    return regions_of(polygon::subtract(disc({0, 0}, outer, 120), disc({0, 0}, outer - wall, 120))).at(0);
}

// Edges of the contour graph, after loops are removed, whose link passes through a third contour.
std::size_t links_through_contours(const Loops& region, const SpiralOptions& o) {
    const auto rings = contours(region, o);
    std::size_t out = 0;
    for (const auto& e : reverse_delete(rings.size(), adjacency(rings, o.threshold * o.offset))) {
        const Vec2 a = rings[static_cast<std::size_t>(e.a)][e.vertex_a];
        const Vec2 b = rings[static_cast<std::size_t>(e.b)][e.vertex_b];
        bool through = false;
        for (std::size_t k = 0; k < rings.size(); ++k)
            for (std::size_t i = 0; i < rings[k].size(); ++i)
                through = through || (static_cast<int>(k) != e.a && static_cast<int>(k) != e.b &&
                                      geom::cross_properly(a, b, rings[k][i], rings[k][(i + 1) % rings[k].size()]));
        out += through ? 1 : 0;
    }
    return out;
}

// F1: beads at fixed depths leave a void of up to a bead along the medial axis, or overlap there by as much.  Walls of
// 4.6 and 5.2 beads: 0.6 of a bead stays empty (1/8 of the wall), 0.8 of a bead overlaps (1/7).
// Property: at least 0.99 of the wall is covered, with the right amount of material within 1 percent.
TEST(FailureModes, F1VoidOrOverlapAtTheMedialAxis) {
    const Loops wide = rectangle(0, 0, 40, 4.6 * kBead), narrow = rectangle(0, 0, 40, 5.2 * kBead);
    EXPECT_LT(coverage(wide, baseline(wide)), 0.89);
    EXPECT_GT(material(narrow, baseline(narrow)), 1.12);
    for (const Loops& wall : {wide, narrow}) {
        EXPECT_GT(coverage(wall, by_default(wall)), 0.99);
        EXPECT_NEAR(material(wall, by_default(wall)), 1, 0.01);
    }
}

// F2: a neck narrower than a bead vanishes in the first offset, and the region falls in two.
// Property: a connected region is one curve.
TEST(FailureModes, F2NeckSplitsTheRegion) {
    const auto discs = polygon::unite(disc({-5, 0}, 3), disc({5, 0}, 3));
    const Loops region = regions_of(polygon::unite(discs, rectangle(-5, -0.15, 5, 0.15))).at(0);
    EXPECT_EQ(baseline(region).size(), 2U);
    EXPECT_EQ(by_default(region).size(), 1U);
}

// F3: a wall thinner than a bead carries no contour at all.
// Property: at least 0.95 of a wall of three quarters of a bead is covered.
TEST(FailureModes, F3ThinWallIsDropped) {
    const Loops wall = rectangle(0, 0, 20, 0.75 * kBead);
    EXPECT_EQ(coverage(wall, baseline(wall), 0.02), 0);
    EXPECT_GT(coverage(wall, by_default(wall), 0.02), 0.95);
}

// F4: the distance between vertices is greater than that between contours, which is one bead between each contour and
// the next.  A square's contours at the lower end of the paper's threshold (1 offset, "1-2 times"), and those of an
// equilateral triangle at 1.5 offsets without vertices but at the corners (2 offsets apart), make a graph in pieces.
// Property: a connected region is one curve.
TEST(FailureModes, F4DistanceOfVerticesSeparatesNeighbours) {
    const Loops square = rectangle(0, 0, 10, 10), triangle = loop({{0, 0}, {10, 0}, {5, 8.66}});
    EXPECT_EQ(baseline(square, {.threshold = 1}).size(), 5U);
    EXPECT_EQ(baseline(triangle, {.sample = 1e9}).size(), 7U);
    EXPECT_EQ(by_default(square).size(), 1U);
    EXPECT_EQ(by_default(triangle).size(), 1U);
}

// F5: at the upper end of the paper's threshold, 2 offsets, contours two levels apart are adjacent as well; links to
// them pass through the contour between.
// Property: the curve of a square of 10 mm does not cross itself.
TEST(FailureModes, F5LinkToTheGrandparentCrossesTheParent) {
    const Loops square = rectangle(0, 0, 10, 10);
    EXPECT_GE(links_through_contours(square, {.threshold = 2}), 5U);
    EXPECT_GE(crossings(baseline(square, {.threshold = 2})), 5U);
    EXPECT_EQ(crossings(by_default(square)), 0U);
}

// F6: contours round a hole make loops in the graph.  Reverse-delete on a matrix of zeros and ones removes them by
// number alone, and keeps links through other contours; and each removal searches the graph anew, so four times the
// holes cost some fifteen times the steps.
// Property: the curve of an annulus does not cross itself.
TEST(FailureModes, F6LoopsOfTheGraph) {
    const Loops ring = annulus(6, 3);
    EXPECT_GE(links_through_contours(ring, {}), 1U);
    EXPECT_GE(crossings(baseline(ring)), 1U);
    EXPECT_EQ(crossings(by_default(ring)), 0U);

    std::vector<double> steps;
    for (const int n : {5, 10}) {
        const Loops sieve = test::sieve(n, 1.2, 0.9);
        const auto rings = contours(sieve, {});
        const auto edges = adjacency(rings, 1.5 * kBead);
        EXPECT_GE(edges.size() - rings.size() + 1, static_cast<std::size_t>(n * n)); // a loop round every hole
        std::size_t looked = 0;
        reverse_delete(rings.size(), edges, &looked);
        steps.push_back(static_cast<double>(looked));
    }
    EXPECT_GT(steps[1] / steps[0], 12);
}

// F7: a child's path goes in beside the vertex of its parent that is nearest, whether other links are there or not, so
// links cross each other and the contours.
// Property: no curve of many shapes crosses itself.
TEST(FailureModes, F7LinksCross) {
    std::size_t regions = 0, crossed = 0, by_us = 0;
    for (unsigned seed = 0; seed < 15; ++seed)
        for (const auto& region : random_regions(seed)) {
            ++regions;
            crossed += crossings(baseline(region)) > 0 ? 1 : 0;
            by_us += crossings(by_default(region)) > 0 ? 1 : 0;
        }
    EXPECT_GT(crossed, regions / 2);
    EXPECT_EQ(by_us, 0U);
}

// F10: contours that come from a hole meet those from the outline only at the medial axis, anything from 0 to 2 beads
// apart.  Annuli of 3 beads and 1.6 and 0.3 between the innermost two: the first falls in two, the second gets a fifth
// more material than there is room for.
// Property: one curve, with the right amount of material within 2 percent.
TEST(FailureModes, F10HoleContoursMeetAtAnyDistance) {
    const Loops apart = annulus(8, (3 + 1.6) * kBead), close = annulus(8, (3 + 0.3) * kBead);
    EXPECT_EQ(baseline(apart).size(), 2U);
    EXPECT_GT(material(close, baseline(close)), 1.15);
    for (const Loops& ring : {apart, close}) {
        EXPECT_EQ(by_default(ring).size(), 1U);
        EXPECT_NEAR(material(ring, by_default(ring)), 1, 0.02);
    }
}

} // namespace
} // namespace filum::baselines::sun2019
