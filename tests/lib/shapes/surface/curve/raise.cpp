#include "surface/curve/raise.hpp"

#include "../grid.hpp"
#include "surface/curve/locate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace filum::surface::curve {
namespace {

using geom::Vec2;

Surface over(const std::function<Vec3(Vec2)>& lift, int n = 40) {
    Notes notes;
    return surface::connect(surface::grid(20, 20, n, n, lift), notes);
}

// The most that vertices of `raised` are off that distance from `s`.
double off_level(const Surface& s, const Surface& raised, double distance) {
    const surface::curve::Locator near(s);
    double out = 0;
    for (const Vec3& p : raised.vertices)
        out = std::max(out, std::abs(geom::distance(p, near.nearest(p).point) - distance));
    return out;
}

TEST(Raise, OfACylinderIsAWiderOne) {
    const auto s = over([](Vec2 p) {
        const double a = p.x / 10;
        return Vec3{10 * std::cos(a), 10 * std::sin(a), p.y};
    });
    const auto up = raised(s, 1.4);
    for (const Vec3& p : up.surface.vertices) EXPECT_NEAR(std::hypot(p.x, p.y), 11.4, 0.005);
    EXPECT_EQ(up.folded, 0);
    EXPECT_EQ(up.blocked, 0);
}

TEST(Raise, OfWavesLiesAtTheTrueDistance) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 5; ++trial) {
        const double deep = 0.5 + 0.1 * (random() % 10), fast = 0.3 + 0.05 * (random() % 5);
        const auto s = over([&](Vec2 p) { return Vec3{p.x, p.y, deep * std::sin(fast * p.x) * std::cos(fast * p.y)}; });
        const auto up = raised(s, 0.8);
        EXPECT_LT(off_level(s, up.surface, 0.8), 0.001) << deep << " " << fast;
        EXPECT_EQ(up.folded, 0) << deep << " " << fast;
    }
}

// A groove with a sharp bottom: along old normals sides would pass through each other.
TEST(Raise, KeepsOffTheOtherSideOfAGroove) {
    const auto s = over([](Vec2 p) { return Vec3{p.x, p.y, std::abs(p.x - 10)}; });
    const auto up = raised(s, 1.2);
    EXPECT_LT(off_level(s, up.surface, 1.2), 0.001);
    for (const Vec3& p : up.surface.vertices) EXPECT_GT(p.z - std::abs(p.x - 10), 1.2 * std::sqrt(2) - 0.01);
    EXPECT_LT(up.folded, 0.02 * surface::area(s));
}

TEST(Raise, OfASharpRidgeIsRound) {
    const auto s = over([](Vec2 p) { return Vec3{p.x, p.y, -std::abs(p.x - 10)}; });
    const auto up = raised(s, 1.2);
    EXPECT_LT(off_level(s, up.surface, 1.2), 0.001);
    EXPECT_EQ(up.folded, 0);
}

TEST(Raise, AsFarAsEachPlaceHasIt) {
    const auto s = over([](Vec2 p) {
        const double a = p.x / 10;
        return Vec3{10 * std::cos(a), 10 * std::sin(a), p.y};
    });
    std::vector<double> distance; // a ramp of 1 in 20 along the axis
    for (const Vec3& p : s.vertices) distance.push_back(std::clamp((p.z - 5) / 20, 0.0, 0.5));
    const auto up = raised(s, distance);
    for (const Vec3& p : up.surface.vertices)
        EXPECT_NEAR(std::hypot(p.x, p.y), 10 + std::clamp((p.z - 5) / 20, 0.0, 0.5), 0.006);
    EXPECT_EQ(up.folded, 0);
    EXPECT_EQ(raised(s, std::vector<double>(s.vertices.size(), 0)).surface.vertices, s.vertices);
}

TEST(Raise, TellsWhereThereIsNoRoom) { // between walls a mm apart
    const auto s = over([](Vec2 p) {
        const double w = p.x - 10;
        return std::abs(w) < 0.5 ? Vec3{w, p.y, 0} : Vec3{w > 0 ? 0.5 : -0.5, p.y, std::abs(w) - 0.5};
    });
    EXPECT_EQ(raised(s, 0.3).blocked, 0);
    const auto up = raised(s, 0.8);
    EXPECT_GT(up.blocked + up.folded, 100);
}

TEST(Raise, TurnedOverTwiceIsTheSame) {
    const auto s = over([](Vec2 p) { return Vec3{p.x, p.y, p.x * p.y / 100}; }, 6);
    const auto back = turned_over(s), again = turned_over(back);
    EXPECT_EQ(again.triangles, s.triangles);
    EXPECT_EQ(again.twin, s.twin);
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t)
        EXPECT_LT(dot(surface::normal(s, t), surface::normal(back, t)), -0.999);
    for (std::uint32_t h = 0; h < back.twin.size(); ++h)
        EXPECT_TRUE(back.twin[h] == surface::kNone || back.tail(h) == back.head(back.twin[h]));
}

} // namespace
} // namespace filum::surface::curve
