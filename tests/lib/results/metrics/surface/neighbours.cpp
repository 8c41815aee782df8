// Gaps between neighbours, and overlap.
#include "metrics/surface/neighbours.hpp"
#include "paths.hpp"

#include <gtest/gtest.h>

namespace filum::metrics::surface {
namespace {

using paths::measure;
using paths::number;
using paths::span;
using paths::Vec2;

const std::string kP1 = "gap / d - 1, p1", kP50 = "gap / d - 1, p50", kP99 = "gap / d - 1, p99";

Surface plate() { return surfaces::sheet(20, 20, 20, 20, 7).surface; }

TEST(Gaps, OfParallelLines) {
    const auto f = measure(plate(), paths::parallel(0, 20, 1, 1.1, 16));
    EXPECT_NEAR(number(f, kP1), 0.1, 1e-9);
    EXPECT_NEAR(number(f, kP99), 0.1, 1e-9);
    EXPECT_NEAR(number(f, "sides with a neighbour"), 30 / 32.0, 1e-9);
    const auto far = measure(plate(), paths::parallel(0, 20, 1, 1.6, 10));
    EXPECT_EQ(number(far, "sides with a neighbour"), 0);
    EXPECT_TRUE(std::isnan(number(far, kP50)));
    Options d;
    d.spacing = 1.6;
    EXPECT_NEAR(number(measure(plate(), paths::parallel(0, 20, 1, 1.6, 10), d), kP50), 0, 1e-9);
}

TEST(Gaps, ToTheNearestOnEitherSide) {
    const auto f = measure(
        plate(), {span({{0, 5, 0}, {20, 5, 0}}), span({{0, 5.8, 0}, {20, 5.8, 0}}), span({{0, 7, 0}, {20, 7, 0}})});
    EXPECT_NEAR(number(f, kP1), -0.2, 1e-9);
    EXPECT_NEAR(number(f, kP99), 0.2, 1e-9);
}

TEST(Gaps, OfAZigzagWithTurns) {
    const auto rows = paths::lifted(paths::zigzag(1, 19, 1, 1, 19), [](Vec2 p) { return Vec3{p.x, p.y, 0}; });
    const auto f = measure(plate(), {span(rows)});
    EXPECT_NEAR(number(f, kP50), 0, 1e-9);
    EXPECT_NEAR(number(f, kP1), 0, 0.1); // some of the turns
    EXPECT_NEAR(number(f, "retraced"), 0, 1e-9);
}

// Turns that overlap the rows beside them, as where rows are laid three apart.
TEST(Gaps, OutsideTurns) {
    std::vector<paths::Span> spans;
    for (int i = 0; i < 3; ++i) {
        auto rows = paths::lifted(paths::zigzag(5, 15, 2.0 + i, 3, 5), [](Vec2 p) { return Vec3{p.x, p.y, 0}; });
        spans.push_back(span(rows));
    }
    const auto f = measure(plate(), spans);
    EXPECT_LT(number(f, kP1, "spacing"), -0.2);
    EXPECT_NEAR(number(f, kP1, "spacing outside turns"), 0, 1e-9);
    EXPECT_NEAR(number(f, kP99, "spacing outside turns"), 0, 1e-9);
    const double share = number(f, "share of the path", "spacing outside turns");
    EXPECT_LT(share, 1);
    EXPECT_GT(share, 0.4);
}

TEST(Gaps, LeaveHairpinsOut) {
    std::vector<paths::Span> lines = paths::parallel(0, 20, 1, 1, 10);
    lines.push_back(span({{0, 10.7, 0}, {20, 10.7, 0}}, 1, toolpath::Role::hairpin));
    EXPECT_NEAR(number(measure(plate(), lines), kP1), 0, 1e-9);
}

TEST(Gaps, AreMeasuredAlongTheSurface) {
    const double r = 2;
    const auto bent = surfaces::sheet(6, 10, 60, 40, 2, [&](Vec2 p) {
        return Vec3{r * std::cos(p.x / r), r * std::sin(p.x / r), p.y};
    });
    std::vector<paths::Span> lines;
    for (int i = 0; i < 6; ++i) {
        const double a = (0.5 + i) / r;
        lines.push_back(span({{r * std::cos(a), r * std::sin(a), 0}, {r * std::cos(a), r * std::sin(a), 10}}));
    }
    const auto f = measure(bent.surface, lines);
    EXPECT_NEAR(number(f, kP50), 0, 5e-4); // the chord is 1 % shorter
}

TEST(Retraced, ThereAndBack) {
    const auto there = span({{2, 5, 0}, {18, 5, 0}, {18, 5.1, 0}, {2, 5.1, 0}});
    EXPECT_NEAR(number(measure(plate(), {there}), "retraced"), 15, 0.6); // except for two widths at the turn
    const auto crossing = measure(plate(), {span({{2, 5, 0}, {18, 5, 0}}), span({{5, 0, 0}, {5, 18, 0}})});
    EXPECT_EQ(number(crossing, "retraced"), 0);
    EXPECT_EQ(number(measure(plate(), paths::parallel(0, 20, 1, 0.5, 30)), "retraced"), 0);
}

TEST(Retraced, NotOnTheOtherSkin) {
    const auto wall = surfaces::sheet(20.2, 10, 101, 20, 4, [](Vec2 p) {
        return p.x <= 10 ? Vec3{p.x, p.y, 0} : p.x <= 10.2 ? Vec3{10, p.y, p.x - 10} : Vec3{20.2 - p.x, p.y, 0.2};
    });
    const auto f = measure(wall.surface, {span({{2, 0, 0}, {2, 10, 0}}), span({{2, 0, 0.2}, {2, 10, 0.2}})});
    EXPECT_EQ(number(f, "retraced"), 0);
    EXPECT_EQ(number(f, "sides with a neighbour"), 0);
}

TEST(Report, IsTheSameForAllThreads) {
    const auto rows = paths::lifted(paths::zigzag(1, 19, 1, 1.03, 17), [](Vec2 p) {
        return Vec3{p.x, p.y, 0.01 * p.x};
    });
    const auto one = measure(plate(), {span(rows)}, {}, 1), more = measure(plate(), {span(rows)}, {}, 3);
    EXPECT_EQ(figures::text(one, figures::Format::tsv), figures::text(more, figures::Format::tsv));
}

} // namespace
} // namespace filum::metrics::surface
