#include "metrics/planar/pores.hpp"

#include "polygon/clip.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace filum::metrics::planar {
namespace {

using polygon::Loops;
using toolpath::Role;
using toolpath::Span;

Loops square(double lo, double hi) {
    Loops out;
    out.add(std::vector<Vec2>{{lo, lo}, {hi, lo}, {hi, hi}, {lo, hi}});
    return out;
}

constexpr double kWidth = 0.4, kHeight = 0.2;

// Strands across a square of `side` mm at the spacing, in layers turned by `degrees` one after the other.
struct Grid {
    std::vector<polygon::Region> regions;
    Beads beads;
    double laid = 0; // mm3

    Grid(double side, double spacing, const std::vector<double>& degrees, double stagger = 0) {
        for (std::uint32_t l = 0; l < degrees.size(); ++l) {
            polygon::Region r;
            r.id = r.layer = l;
            r.z = kHeight * (l + 1);
            r.height = kHeight;
            r.loops = square(-side / 2, side / 2);
            r.area = side * side;
            regions.push_back(r);
        }
        beads.marks = layer_marks(regions);
        for (std::uint32_t l = 0; l < degrees.size(); ++l) {
            const double a = degrees[l] * std::numbers::pi / 180, half = side / 2;
            const double shift = l / 2 % 2 == 0 ? 0 : stagger;
            for (double k = -20 * side; k <= 20 * side; k += 1) {
                // the line n . p = k * spacing, cut to the square
                const Vec2 u{std::cos(a), std::sin(a)}, n = geom::left_of(u);
                double lo = -2 * side, hi = 2 * side;
                const auto clip = [&](double along, double at) {
                    if (std::abs(along) < 1e-9) {
                        if (std::abs(at) > half) hi = lo;
                        return;
                    }
                    lo = std::max(lo, std::min((-half - at) / along, (half - at) / along));
                    hi = std::min(hi, std::max((-half - at) / along, (half - at) / along));
                };
                const Vec2 base = (k + 0.5 + shift) * spacing * n;
                clip(u.x, base.x);
                clip(u.y, base.y);
                if (hi - lo < 0.01) continue;
                const Vec2 p = base + lo * u, q = base + hi * u;
                const double z = kHeight * (l + 1);
                add(beads, Span{Role::bead, 0, l, l, {{p.x, p.y, z}, {q.x, q.y, z}}, {kWidth}, {kHeight}});
                add(beads, Span{Role::travel, 0, l, l, {}, {}, {}});
                laid += (hi - lo) * kWidth * kHeight;
            }
        }
    }
    [[nodiscard]] Pores pores(int threads = 1) const {
        return measure_pores(beads, regions, measure_layers(beads, regions, 0.02, threads), threads);
    }
};

TEST(Pores, OfACrossedGridAreItsSquares) {
    const Grid grid(12, 1, {0, 90, 0, 90});
    const Pores p = grid.pores();
    ASSERT_EQ(p.layers.size(), 4U);
    for (const auto& l : p.layers) {
        EXPECT_EQ(l.strands, 12U);
        EXPECT_NEAR(l.spacing, 1, 1e-6);
        EXPECT_NEAR(l.width, 0.4, 1e-6);
        EXPECT_EQ(l.openings.size(), 11U * 11U); // those at the border are open
        EXPECT_NEAR(l.openings.front().diameter, 0.6, 0.003);
        EXPECT_NEAR(l.openings.back().diameter, 0.6, 0.003);
        EXPECT_NEAR(l.lateral, kHeight, 1e-9);
    }
    EXPECT_NEAR(p.layers[0].direction, 0, 1e-6);
    EXPECT_NEAR(p.layers[1].direction, std::numbers::pi / 2, 1e-6);
    ASSERT_EQ(p.through.size(), 121U);
    EXPECT_NEAR(p.through.front(), 0.6, 0.003);
    EXPECT_NEAR(p.part, 12 * 12 * 0.8, 1e-6);
    EXPECT_NEAR(p.material, grid.laid, 1e-4);
    EXPECT_NEAR(1 - p.material / p.part, 0.6, 1e-3);
    EXPECT_NEAR(1 - p.covered / p.area, 0.6, 2e-3);
}

TEST(Pores, FollowTheSpacing) {
    for (const double spacing : {0.5, 0.7, 1.3, 2.0}) {
        const Pores p = Grid(10, spacing, {0, 90}).pores();
        ASSERT_FALSE(p.layers[0].openings.empty());
        EXPECT_NEAR(p.layers[0].openings.front().diameter, spacing - kWidth, 0.003);
        EXPECT_NEAR(p.through.back(), spacing - kWidth, 0.003);
        EXPECT_NEAR(p.layers[0].lateral, std::min(kHeight, spacing - kWidth), 1e-6);
    }
}

TEST(Pores, OfTwoDirectionsAreRhombs) {
    // the circle in a rhomb is as wide as the gap, at any angle
    for (const double degrees : {30.0, 60.0, 75.0}) {
        const Pores p = Grid(14, 1.2, {0, degrees}).pores();
        ASSERT_FALSE(p.layers[0].openings.empty());
        EXPECT_NEAR(p.layers[0].openings[p.layers[0].openings.size() / 2].diameter, 0.8, 0.003);
        EXPECT_NEAR(p.layers[1].direction, degrees * std::numbers::pi / 180, 1e-6);
    }
}

TEST(Pores, LayersOfOneDirectionMakeHigherChannels) {
    const Pores p = Grid(8, 1, {0, 0, 90, 90}).pores();
    for (const auto& l : p.layers) EXPECT_NEAR(l.lateral, 2 * kHeight, 1e-9);
    for (const auto& l : p.layers)
        EXPECT_NEAR(l.openings.front().diameter, 0.6, 0.003); // seen through to the other direction
}

TEST(Pores, StaggeredRoundsNarrowTheVerticalThroat) {
    const Pores p = Grid(10, 1, {0, 90, 0, 90}, 0.5).pores();
    EXPECT_NEAR(p.layers[0].openings.front().diameter, 0.6, 0.003);
    ASSERT_FALSE(p.through.empty());
    EXPECT_NEAR(p.through.back(), 0.1, 0.003);
}

TEST(Pores, ASolidLayerHasNone) {
    const Pores p = Grid(6, kWidth, {0, 90}).pores();
    EXPECT_TRUE(p.layers[0].openings.empty());
    EXPECT_TRUE(p.through.empty());
    EXPECT_EQ(p.layers[0].spacing, 0);
    EXPECT_EQ(p.layers[0].lateral, 0);
}

TEST(Pores, AnEmptyPartIsNoTrouble) {
    EXPECT_TRUE(measure_pores({}, {}, {}, 1).layers.empty());
    Grid grid(6, 1, {0, 90});
    grid.beads.layer.clear();
    const Pores p = grid.pores();
    EXPECT_EQ(p.material, 0);
    EXPECT_EQ(p.layers[0].strands, 0U);
    Figures figures;
    pore_figures(p, figures);
    EXPECT_EQ(std::get<double>(figures[0].value), 1);
}

TEST(Pores, AreTheSameForAnyThreads) {
    const Grid grid(7, 0.9, {0, 60, 120});
    const Pores a = grid.pores(1), b = grid.pores(8);
    EXPECT_EQ(a.through, b.through);
    EXPECT_EQ(pore_table(a), pore_table(b));
}

TEST(Pores, InscribedCircles) {
    EXPECT_NEAR(inscribed_circle(square(0, 3)), 3, 0.003);
    Loops triangle; // 3 4 5: inradius 1
    triangle.add(std::vector<Vec2>{{0, 0}, {4, 0}, {0, 3}});
    EXPECT_NEAR(inscribed_circle(triangle), 2, 0.003);
    EXPECT_NEAR(inscribed_circle(polygon::subtract(square(0, 5), square(1, 4))), 2 * (2 - std::sqrt(2)), 0.003);
}

} // namespace
} // namespace filum::metrics::planar
