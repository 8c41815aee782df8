#include "fill/scaffold/fronts.hpp"

#include "base/error.hpp"
#include "fill/scaffold/scaffold.hpp"
#include "geom/segment.hpp"
#include "polygon/loops.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace filum::fill::scaffold {
namespace {

const geom::Box2 kBox{{-10, -10}, {10, 10}};

double to_line(std::span<const Vec2> line, Vec2 p) {
    double least = 1e9;
    for (std::size_t i = 1; i < line.size(); ++i)
        least = std::min(least, geom::point_segment_distance(line[i - 1], line[i], p));
    return least;
}

TEST(Fronts, ConstantSpacingGivesStraightRows) {
    const Fronts f(kBox, 0.2, [](Vec2) { return 0.9; });
    EXPECT_NEAR(f.y(3, 0), 0, 1e-12);
    EXPECT_NEAR(f.y(-7, 4), 3.6, 1e-9);
    EXPECT_NEAR(f.y(5, -4.5), -4.05, 1e-9);
    EXPECT_NEAR(f.level({2, 1.8}), 2, 1e-9);
    EXPECT_EQ(f.line(-5, 5, 3).size(), 2U);
}

TEST(Fronts, NeighboursAreAsFarApartAsTheSpacingSays) {
    std::mt19937 random(7);
    const auto uniform = [&](double lo, double hi) { return lo + (hi - lo) * (random() / 4294967295.0); };
    for (int trial = 0; trial < 30; ++trial) {
        const double middle = uniform(0.8, 1.2), x = uniform(-0.02, 0.02), y = uniform(-0.02, 0.02);
        const SpacingAt spacing = [&](Vec2 p) { return middle + x * p.x + y * p.y; };
        const Fronts f(kBox, 0.2, spacing);
        for (double level = -6; level <= 5; ++level) {
            const auto lower = f.line(-10, 10, level), upper = f.line(-10, 10, level + 1);
            for (double at = -7; at <= 7; at += 0.5) {
                const Vec2 p{at, f.y(at, level + 0.5)};
                const double apart = to_line(lower, p) + to_line(upper, p);
                EXPECT_NEAR(apart, spacing(p), 0.012 * spacing(p)) << trial << " level " << level << " x " << at;
            }
        }
    }
}

TEST(Fronts, LevelsAndHeightsAreInverse) {
    const Fronts f(kBox, 0.2, [](Vec2 p) { return 0.8 + 0.03 * std::hypot(p.x, p.y); });
    for (double x = -10; x <= 10; x += 0.7)
        for (double y = -10; y <= 10; y += 0.7) EXPECT_NEAR(f.y(x, f.level({x, y})), y, 1e-9);
}

TEST(Fronts, RefusesSpacingsThatDifferTooMuch) {
    EXPECT_THROW(Fronts(kBox, 0.2, [](Vec2 p) { return p.x < 0 ? 0.5 : 6; }), Error);
}

Loops round_part(double r) {
    std::vector<Vec2> out;
    for (int i = 0; i < 96; ++i) out.push_back({r * std::cos(i * 0.0654498), r * std::sin(i * 0.0654498)});
    Loops loops;
    loops.add(out);
    return loops;
}

TEST(Fronts, AScaffoldOfBentStrandsIsOneCurveInside) {
    const Loops part = round_part(8);
    for (const double angle : {0.0, 0.7, 1.5708}) {
        ScaffoldOptions o{.bead_width = 0.4, .spacing = 1, .angle = angle};
        o.spacing_at = [](Vec2 p) { return 0.8 + 0.03 * (p.x + 8); };
        Notes notes;
        const auto curves = scaffold(part, part, o, notes);
        ASSERT_EQ(curves.size(), 1U);
        for (const Vec2 p : curves[0].points) EXPECT_LE(geom::norm(p), 8 - 0.19);
        double length = 0;
        for (std::size_t i = 1; i < curves[0].points.size(); ++i)
            length += geom::distance(curves[0].points[i - 1], curves[0].points[i]);
        EXPECT_NEAR(length, 3.14159 * 64 / 1.04, 0.12 * length); // area by the mean spacing, and the turns
    }
}

} // namespace
} // namespace filum::fill::scaffold
