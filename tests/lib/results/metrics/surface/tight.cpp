// Tight turns are found by the shape of the path, whatever its points and roles.
#include "metrics/surface/tight.hpp"
#include "paths.hpp"

#include <gtest/gtest.h>

namespace filum::metrics::surface {
namespace {

using paths::Vec2;
using std::numbers::pi;

// Straight on for 10 mm, half round with a radius, and back.
std::vector<Vec3> hook(double radius, double apart) {
    std::vector<Vec2> flat{{0, 0}};
    const auto half = paths::arc({10, radius}, radius, -pi / 2, pi / 2, [=] { return apart; });
    flat.insert(flat.end(), half.begin(), half.end());
    flat.push_back({0, 2 * radius});
    return paths::lifted(flat, [](Vec2 p) { return Vec3{p.x, p.y, 0}; });
}

TightTurns measured(const std::vector<paths::Span>& spans, double radius) {
    const Fibres fibres = paths::fibres(spans);
    std::vector<std::vector<Vec3>> normals;
    for (const Chain& c : fibres.chains) normals.emplace_back(c.points.size(), Vec3{0, 0, 1});
    return tight(fibres, normals, radius);
}

TEST(Tight, HalfCirclesOfAnyPoints) {
    for (const double apart : {0.01, 0.1, 0.23})
        for (const double radius : {0.5, 1.0, 2.0, 3.0}) {
            const auto t = measured({paths::span(hook(radius, apart))}, 2.4);
            const bool within = radius < 2.4;
            EXPECT_EQ(t.count, within ? 1U : 0U) << radius;
            EXPECT_NEAR(t.length, within ? pi * radius : 0, within ? 0.5 : 0) << radius;
            EXPECT_EQ(t.undeclared, t.length); // no hairpin was said
            EXPECT_NEAR(t.least, radius, 0.07 * radius) << apart;
            if (within) {
                EXPECT_GT(t.tightest.x, 9.7);
                EXPECT_GT(t.undeclared_at.x, 9.7);
            }
        }
}

TEST(Tight, CornersCountByTheirAngle) {
    const auto t = measured({paths::span({{0, 0, 0}, {5, 0, 0}, {10, 0.5, 0}})}, 2.4);
    const double angle = std::atan2(0.5, 5);
    EXPECT_NEAR(t.least, 0.25 / (2 * std::sin(angle / 2)), 0.15); // looked at within 0.025 mm of the corner
    EXPECT_NEAR(measured({paths::span({{0, 0, 0}, {5, 0, 0}, {0, 0.2, 0}})}, 2.4).least, 0.125, 1e-9);
    EXPECT_EQ(measured({paths::span({{0, 0, 0}, {5, 0, 0}})}, 2.4).count, 0U);
}

// The role takes nothing from what is tight: only from what is not declared.
TEST(Tight, WhatIsDeclaredIsTightStill) {
    const auto all = hook(1, 0.1);
    const auto plain = measured({paths::span(all)}, 2.4);
    const auto middle = static_cast<std::ptrdiff_t>(all.size() / 2);
    const std::vector<Vec3> first(all.begin(), all.begin() + middle + 1), second(all.begin() + middle, all.end());
    const auto half = measured({paths::span(first, 1, paths::Role::hairpin), paths::span(second)}, 2.4);
    EXPECT_EQ(half.count, plain.count);
    EXPECT_NEAR(half.length, plain.length, 1e-9);
    EXPECT_NEAR(half.undeclared, plain.length / 2, 0.2);
    EXPECT_GT(half.undeclared_at.y, 0.9);
    EXPECT_EQ(measured({paths::span(all, 1, paths::Role::hairpin)}, 2.4).undeclared, 0);
}

} // namespace
} // namespace filum::metrics::surface
