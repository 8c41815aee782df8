// Cells by index against Boolean operations, and cells with round corners against openings.
#include "infill/strips.hpp"

#include "../../trials.hpp"
#include "../fill/pattern_check.hpp"
#include "infill/cells.hpp"
#include "infill/opening.hpp"
#include "infill/ruler.hpp"
#include "polygon/clip.hpp"
#include "polygon/simple.hpp"

#include <cmath>

namespace filum::infill {
namespace {

using polygon::InfillPattern;

constexpr double kBead = 0.4;

double difference(const Loops& a, const Loops& b) {
    return polygon::signed_area(polygon::subtract(a, b)) + polygon::signed_area(polygon::subtract(b, a));
}

// Lines of every kind: few and many, with and without further lines.
Lines mixed_lines(unsigned seed) {
    const double spacing[] = {0.7, 1.3, 3, 9, 40};
    return {.pattern = seed % 2 == 0 ? InfillPattern::rows : InfillPattern::wave,
            .direction = seed % 4 < 2 ? 0.7853981633974483 * (seed % 5) : 0.1 * seed,
            .spacing = spacing[seed % 5],
            .bead_width = kBead,
            .z = 0.2 * seed,
            .gap = seed % 3 == 0 ? 2.0 : 0.0};
}

TEST(Strips, CellsAreThoseOfABooleanOperation) {
    unsigned areas = 0;
    for (unsigned seed = 0, n = trials(60); seed < n; ++seed)
        for (Loops area : test::random_regions(seed)) {
            for (auto& p : area.points) p = 2.0 * p;
            const Lines lines = mixed_lines(seed);
            const auto cells = in_even_cells(area, lines);
            ASSERT_TRUE(cells) << seed;
            const Loops twin = polygon::intersect(area, even_cells(area, lines));
            // Clipper rounds to its grid
            EXPECT_LE(difference(*cells, twin), polygon::kGridStep * length(twin)) << seed;
            EXPECT_NEAR(length(*cells), length(twin), 0.01 + 1e-3 * length(twin)) << seed;
            ++areas;
        }
    EXPECT_GE(areas, kSanitized ? 1U : 40U);
}

// Outlines along lines, through their knots, and with corners on them.
TEST(Strips, OutlinesOnLinesAreCut) {
    const Lines rows{InfillPattern::rows, 0, 2, kBead, 0};
    const std::pair<Loops, double> cases[] = {
        {test::loop({{0, 0}, {10, 0}, {10, 2}, {0, 2}}), 20},                                   // an even cell
        {test::loop({{0, 2}, {10, 2}, {10, 4}, {0, 4}}), 0},                                    // an odd one
        {test::loop({{0, 0}, {10, 0}, {10, 8}, {0, 8}}), 40},                                   // two of each
        {test::loop({{5, 0}, {7, 2}, {5, 4}, {3, 2}}), 4},                                      // corners on lines
        {test::loop({{0, 1}, {4, 1}, {4, 2}, {6, 2}, {6, 1}, {9, 1}, {9, 5}, {0, 5}}), 7 + 9}}; // an edge on a line
    for (const auto& [area, wanted] : cases) {
        const auto cells = in_even_cells(area, rows);
        ASSERT_TRUE(cells);
        EXPECT_NEAR(polygon::signed_area(*cells), wanted, 1e-9);
    }
}

// A cell loses what is narrower than a bead, whichever way it is opened.
TEST(Strips, CellsAreOpenedAsByBooleanOperations) {
    for (unsigned seed = 0, n = trials(30); seed < n; ++seed)
        for (Loops area : test::random_regions(seed)) {
            for (auto& p : area.points) p = 2.0 * p;
            const auto cells = in_even_cells(area, mixed_lines(seed));
            ASSERT_TRUE(cells) << seed;
            const Loops opened = opened_cells(*cells, kBead / 2);
            const Loops twin = polygon::opened(*cells, kBead / 2, polygon::kBeadArc);
            EXPECT_TRUE(opened.empty() || polygon::is_simple(opened)) << seed;
            EXPECT_LE(difference(opened, twin), polygon::kBeadArc * length(twin)) << seed;
            EXPECT_NEAR(length(opened), length(twin), 0.1 + 0.01 * length(twin)) << seed;
        }
}

// The disc leaves arcs in corners. The line there has one point in an obtuse corner, two in others, and is off by at
// most an eighth of a bead.
TEST(Strips, CornersOfCellsHaveFewPoints) {
    for (int k = 1; k < 18; ++k) {
        const double angle = k * std::numbers::pi / 18; // of the corners at (0, 0) and (h, h)
        const geom::Vec2 side{10 * std::cos(angle), 10 * std::sin(angle)};
        const Loops cell = test::loop({{0, 0}, {20, 0}, geom::Vec2{20, 0} + side, side});
        const Loops opened = opened_cells(cell, kBead / 2);
        EXPECT_LE(opened.points.size(), 8U) << k;
        const Loops twin = polygon::opened(cell, kBead / 2, polygon::kBeadArc);
        EXPECT_TRUE(polygon::subtract(polygon::offset(opened, -kBead / 8), twin).empty()) << k;
        EXPECT_LT(polygon::signed_area(polygon::subtract(opened, cell)), 1e-3) << k;
        EXPECT_LT(polygon::signed_area(polygon::subtract(twin, opened)), 0.02 * kBead * kBead) << k;
    }
}

// Where lines are far apart, even cells stay narrow, and squares are no wider than those.
TEST(Strips, FewLinesLieInPairs) {
    for (const double spacing : {1.0, 6.4, 6.5, 9.0, 20.0, 77.0}) {
        const Lines lines{InfillPattern::rows, 0, spacing, kBead, 0};
        const Ruler ruler(lines), squares = Ruler::of_squares(lines);
        const double even = std::min(spacing, kWidestCell * kBead);
        for (int k = -3; k < 3; ++k) {
            EXPECT_NEAR(ruler.place(2 * k), 2 * spacing * k + spacing - even, 1e-9);
            EXPECT_NEAR(ruler.place(2 * k + 1), 2 * spacing * k + spacing, 1e-9);
            EXPECT_NEAR(ruler.even(ruler.place(2 * k + 1)) - ruler.even(ruler.place(2 * k)), even, 1e-9);
        }
        for (int k = -9; k < 9; ++k) EXPECT_LE(squares.place(k + 1) - squares.place(k), even + 1e-9);
        for (double v = -3 * spacing; v < 3 * spacing; v += 0.37) {
            EXPECT_LE(ruler.place(ruler.below(v)), v);
            EXPECT_GT(ruler.place(ruler.below(v) + 1), v);
        }
    }
}

} // namespace
} // namespace filum::infill
