// Closed beads along rims: rows end inside of them, in plates of many sizes with a hole anywhere.
#include "surfpath/rows/rows.hpp"

#include "surface/curve/locate.hpp"
#include "surface/curve/walk.hpp"

#include "../../../shapes/surface/grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace filum::surfpath {

using namespace rows;
namespace {

// A plate of w x h mm with a hole.
Surface pierced(double w, double h, geom::Vec2 hole) {
    Notes notes;
    return surface::connect(surface::pierced_grid(
                                w, h, static_cast<int>(w), static_cast<int>(h),
                                [](geom::Vec2 p) {
                                    return Vec3{p.x, p.y, 0};
                                },
                                [&](geom::Vec2 p) { return std::hypot(p.x - hole.x, p.y - hole.y) < 2.5; }),
                            notes);
}

// mm: from the straight outer rims of the plate.
double from_outer(const Vec3& p, double w, double h) { return std::min({p.x, p.y, w - p.x, h - p.y}); }

TEST(RimBeads, RowsEndInsideOfThem) {
    std::mt19937 random(7);
    const auto between = [&](double lo, double hi) { return std::uniform_real_distribution(lo, hi)(random); };
    for (int i = 0; i < 12; ++i) {
        const double w = std::round(between(24, 40)), h = std::round(between(24, 40)), d = between(0.6, 1.2);
        const Surface s = pierced(w, h, {between(10, w - 10), between(10, h - 10)});
        const surface::curve::Locator locator(s);
        std::vector<UnclippedLine> lines;
        for (double y = 0.4 * d; y < 6; y += d) { // below the hole, so that all lines lead through
            Line line{{locator.nearest({0, y, 0}), locator.nearest({w, y, 0})}, false};
            lines.push_back({surface::curve::threaded(s, line), y});
        }
        for (unsigned beads = 0; beads < 4; ++beads) {
            const double wide = between(0.8, 1.2) * d, on_it = beads > 0 ? 1 - std::numbers::pi / 4 : 0;
            const double margin = beads * wide + d / 2 - on_it * d;
            const Rows found = rows::rows(s, lines, {d / 2, d / 2, d / 2, d / 10, beads, wide});
            std::size_t closed = 0;
            for (const Row& row : found.rows) {
                closed += row.line.closed ? 1 : 0;
                if (row.line.closed) continue;
                for (const Place& p : {row.line.places.front(), row.line.places.back()})
                    EXPECT_GE(from_outer(p.point, w, h), margin - 0.11 * d) << i << ", " << beads;
            }
            EXPECT_EQ(closed, 2 * beads) << i; // the outer rim and the hole's
            EXPECT_NEAR(found.inset.margin, margin, 1e-9);
            EXPECT_DOUBLE_EQ(found.inset.half, d / 2);
        }
    }
}

} // namespace
} // namespace filum::surfpath
