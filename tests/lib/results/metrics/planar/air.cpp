#include "metrics/planar/air.hpp"
#include "../../../trials.hpp"
#include "toolpaths.hpp"

#include "geom/segment.hpp"

#include <random>

namespace filum::metrics::planar {
namespace {

void add_lines(Beads& to, Vec2 at, double w, double h, std::uint32_t layer) {
    for (auto s : lines(w, h, 0.4, 0.4, 0.2 * (layer + 1), layer)) {
        for (auto& p : s.points) {
            p.x += at.x;
            p.y += at.y;
        }
        add(to, s);
        to.moving = false;
    }
}

TEST(Air, ATHangsOnBothSides) {
    Beads b;
    for (std::uint32_t l = 0; l < 5; ++l) add_lines(b, {15, 0}, 10, 4, l);
    for (std::uint32_t l = 5; l < 8; ++l) add_lines(b, {0, 0}, 40, 4, l);
    const Air a = measure_air(b, 0, 1);
    // the arms from half a bead beyond the rounded ends of the beads below, with rounded ends of their own
    EXPECT_NEAR(a.area, 2 * 4 * (15 - 0.4 + 0.2), 0.3);
    EXPECT_NEAR(a.length, 2 * 10 * (15 - 0.4), 0.1);
    EXPECT_EQ(a.layers, 1U);
    EXPECT_EQ(a.layer, 5U);
    EXPECT_NEAR(a.longest, 15 - 0.4, 0.01);
}

TEST(Air, ABridgeIsOneStretch) {
    Beads b;
    add_lines(b, {0, 0}, 10, 4, 0);
    add_lines(b, {30, 0}, 10, 4, 0);
    add(b, bead({{0, 2.2, 0.4}, {17, 2.2, 0.4}, {20, 2.2, 0.4}, {40, 2.2, 0.4}}, 0.4, 0.2, 1));
    const Air a = measure_air(b, 0, 1);
    EXPECT_NEAR(a.longest, 20 - 0.8, 1e-6);
    EXPECT_NEAR(a.length, 20 - 0.8, 1e-6);
    EXPECT_NEAR(a.at.x, 10.4, 1e-6);
}

TEST(Air, TheBedCarriesAndHalfABeadMayOverhang) {
    Beads b;
    add(b, bead({{0, 0, 0.2}, {10, 0, 0.2}}));
    add(b, bead({{0, 0.39, 0.4}, {10, 0.39, 0.4}}, 0.4, 0.2, 1));
    EXPECT_EQ(measure_air(b, 0, 1).length, 0);
    b.moving = false;
    add(b, bead({{0, 0.8, 0.6}, {10, 0.8, 0.6}}, 0.4, 0.2, 2)); // 0.41 aside of the one below
    EXPECT_NEAR(measure_air(b, 0, 1).length, 10, 1e-6);
}

TEST(Air, ALayerThatIsMissingCarriesNothing) {
    Beads b;
    add_lines(b, {0, 0}, 10, 4, 0);
    add_lines(b, {0, 0}, 10, 4, 2);
    EXPECT_NEAR(measure_air(b, 0, 1).length, 100, 1e-6);
}

// Against samples, each asked for its distance to every bead below.
TEST(Air, AgreesWithSamples) {
    std::mt19937 random(3);
    const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (random() / 4294967295.0); };
    for (int trial = 0; trial < trials(40); ++trial) {
        Beads b;
        for (std::uint32_t layer = 0; layer < 2; ++layer) {
            b.moving = false;
            std::vector<geom::Vec3> way;
            for (int i = 0; i < 12; ++i) way.push_back({uniform(0, 5), uniform(0, 5), 0.2 * (layer + 1)});
            add(b, bead(way, layer == 0 ? 0.6 : 0.4, 0.2, layer));
        }
        const LayerBeads &low = b.layer[0], &up = b.layer[1];
        const auto carried = [&](Vec2 p) {
            for (std::size_t i = 0; i + 1 < low.points.size(); ++i)
                if (geom::point_segment_distance(low.points[i], low.points[i + 1], p) <= 0.3 + 0.2) return true;
            return false;
        };
        double length = 0, longest = 0, now = 0;
        for (std::size_t i = 0; i + 1 < up.points.size(); ++i) {
            const double l = geom::distance(up.points[i], up.points[i + 1]);
            for (int k = 0; k < 2000; ++k) {
                const bool free = !carried(geom::lerp(up.points[i], up.points[i + 1], (k + 0.5) / 2000));
                now = free ? now + l / 2000 : 0;
                length += free ? l / 2000 : 0;
                longest = std::max(longest, now);
            }
        }
        double area = 0;
        constexpr double kStep = 0.02;
        for (double x = -1; x < 6; x += kStep)
            for (double y = -1; y < 6; y += kStep) {
                double near = 1e9;
                for (std::size_t i = 0; i + 1 < up.points.size(); ++i)
                    near = std::min(near, geom::point_segment_distance(up.points[i], up.points[i + 1], {x, y}));
                if (near <= 0.2 && !carried({x, y})) area += kStep * kStep;
            }
        const Air a = measure_air(b, 0.01, 1);
        EXPECT_NEAR(a.length, length, 0.05) << trial;
        EXPECT_NEAR(a.longest, longest, 0.02) << trial;
        EXPECT_NEAR(a.area, area, 0.05) << trial;
    }
}

} // namespace
} // namespace filum::metrics::planar
