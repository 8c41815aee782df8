// Tips without room for two lanes, and what becomes of a curve on the micrometre grid.
#include "../shapes.hpp"
#include "fill/join/crossings.hpp"
#include "fill/spiral.hpp"

#include <gtest/gtest.h>

namespace filum {
namespace {

using geom::Vec2;
using polygon::Loops;

Loops triangle(Vec2 a, Vec2 b, Vec2 c) {
    Loops out;
    out.add(std::vector<Vec2>{a, b, c});
    return out;
}

// Regions that meet tip to tip or tip to edge, at many angles: each is filled alone, yet their beads must not meet.
TEST(Tips, OfNeighboursDoNotCross) {
    for (int k = 0; k < 60; ++k) {
        const double a = 0.1 * k, half = 0.02 + 0.004 * k;
        const auto ray = [](double angle, double l) { return l * Vec2{std::cos(angle), std::sin(angle)}; };
        Notes notes;
        std::vector<toolpath::Curve> curves;
        for (const double way : {a, a + 2.4, a + 4.3}) {
            const auto s =
                fill::spiral(triangle({0, 0}, ray(way - half, 6), ray(way + half, 6)), {.bead_width = 0.4}, notes);
            ASSERT_EQ(s.curves.size(), 1U);
            curves.insert(curves.end(), s.curves.begin(), s.curves.end());
        }
        EXPECT_EQ(fill::join::crossing_pairs(curves, 0.4).size(), 0U)
            << "tips of " << 2 * half << " rad, turned by " << a;
    }
}

// A bead that runs back over itself would cross itself where it is cut and rounded.  The region is where two struts of
// a lattice meet.
TEST(Tips, LeaveNoSpikes) {
    Loops joint;
    joint.add(std::vector<Vec2>{{0.3292, 11.407},
                                {0.4114, 11.4337},
                                {0.6657, 11.7837},
                                {0.6657, 12.2163},
                                {0.4114, 12.5663},
                                {0.0823, 12.6733},
                                {0, 12.7},
                                {-0.4114, 12.5663},
                                {-0.6657, 12.2163},
                                {-0.6657, 11.7837},
                                {-0.4114, 11.4337},
                                {0, 11.3}});
    Notes notes;
    const auto s = fill::spiral(joint, {.bead_width = 0.4}, notes);
    ASSERT_EQ(s.curves.size(), 1U);
    const auto& c = s.curves[0].points;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const Vec2 p = c[i], q = c[(i + 1) % c.size()], r = c[(i + 2) % c.size()];
        EXPECT_NE(p, q);
        if (geom::dot(q - p, r - q) > 0) continue;
        EXPECT_GE(geom::point_segment_distance(q, r, p), 0.002);
        EXPECT_GE(geom::point_segment_distance(p, q, r), 0.002);
    }
}

} // namespace
} // namespace filum
