// Tight turns are found by the shape of the path alone: points and roles do not count.
#include "metrics/surface/tight.hpp"
#include "base/mix.hpp"
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

TightLength measured(const std::vector<paths::Span>& spans, double radius, double spacing = 1) {
    const Fibres fibres = paths::fibres(spans);
    std::vector<std::vector<Vec3>> normals;
    for (const Fibre& c : fibres.all) normals.emplace_back(c.points.size(), Vec3{0, 0, 1});
    return tight(fibres, normals, radius, spacing);
}

std::vector<Vec3> curve(double length, double step, const std::function<Vec2(double)>& at) {
    std::vector<Vec3> out;
    const int n = static_cast<int>(std::ceil(length / step));
    for (int i = 0; i <= n; ++i) {
        const Vec2 p = at(length * i / n);
        out.push_back({p.x, p.y, 0});
    }
    return out;
}

// The same measure with code of its own: points every 0.002 mm along the path, and the curvature by the angle between
// both chords. mm of places of less than `radius`.
double by_brute_force(const std::vector<Vec3>& path, double radius, double spacing) {
    constexpr double kStep = 0.002; // mm
    std::vector<Vec3> at;
    double left = 0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const double l = distance(path[i], path[i + 1]);
        for (; left < l; left += kStep) at.push_back(path[i] + left / l * (path[i + 1] - path[i]));
        left -= l;
    }
    const double reach = std::max(spacing / 4, std::sqrt(4 * 0.02 * spacing * radius));
    const auto n = static_cast<std::size_t>(std::lround(reach / kStep));
    double out = 0;
    for (std::size_t i = n; i + n < at.size(); ++i) {
        const Vec3 a = at[i] - at[i - n], b = at[i + n] - at[i];
        const double turn = std::atan2(std::abs(a.x * b.y - a.y * b.x), dot(a, b));
        const double r = turn > pi / 2 ? reach / 2 : (norm(a) + norm(b)) / 4 / std::sin(turn / 2);
        out += r < radius ? kStep : 0;
    }
    return out;
}

TEST(Tight, HalfCirclesOfAnyPoints) {
    for (const double apart : {0.01, 0.1, 0.23})
        for (const double radius : {0.5, 1.0, 2.0, 3.0}) {
            const auto t = measured({paths::span(hook(radius, apart))}, 2.4);
            const bool within = radius < 2.4;
            EXPECT_EQ(t.count, within ? 1U : 0U) << radius;
            EXPECT_NEAR(t.length, within ? pi * radius : 0, within ? 0.5 : 0) << radius;
            EXPECT_NEAR(t.least, radius, 0.07 * radius) << apart;
            if (within) {
                EXPECT_GT(t.tightest.x, 9.5);
            }
        }
}

// A turn to the neighbouring line has half a spacing, and is no kink; a tighter one is.
TEST(Tight, KinksBeginBelowTheTurnToTheNeighbour) {
    for (const double spacing : {0.4, 1.0, 3.0})
        for (const double radius : {0.3, 0.42, 0.48, 0.5}) {
            const auto t = measured({paths::span(hook(radius * spacing, 0.01 * spacing))}, 0.45 * spacing, spacing);
            EXPECT_EQ(t.count, radius < 0.45 ? 1U : 0U) << spacing << " " << radius;
            if (radius < 0.45) {
                EXPECT_NEAR(t.length, pi * radius * spacing, 0.5 * spacing);
            }
        }
}

TEST(Tight, CornersCountByTheirAngle) {
    const auto t = measured({paths::span({{0, 0, 0}, {5, 0, 0}, {10, 0.5, 0}})}, 0.45);
    const double angle = std::atan2(0.5, 5);
    EXPECT_NEAR(t.least, 0.25 / (2 * std::sin(angle / 2)), 0.15); // looked at within 0.025 mm of the corner
    EXPECT_NEAR(measured({paths::span({{0, 0, 0}, {5, 0, 0}, {0, 0.2, 0}})}, 0.45).least, 0.125, 1e-9);
    EXPECT_EQ(measured({paths::span({{0, 0, 0}, {5, 0, 0}})}, 2.4).count, 0U);
    for (const double degrees : {20.0, 60.0, 100.0, 150.0}) {
        const double a = degrees * pi / 180;
        const auto corner = paths::span({{0, 0, 0}, {5, 0, 0}, {5 + 5 * std::cos(a), 5 * std::sin(a), 0}});
        EXPECT_EQ(measured({corner}, 2.4).count, 1U) << degrees;
        EXPECT_EQ(measured({corner}, 0.45).count, degrees > 33 ? 1U : 0U) << degrees;
    }
}

// An S-curve y = h sin(kx): where its curvature exceeds the limit by a tenth it is tight, and not where it stays a
// tenth below. Its length is known within the reach at both ends of each bend.
TEST(Tight, SCurvesByTheirCurvature) {
    for (const double height : {0.5, 1.5, 4.0})
        for (const double wave : {8.0, 16.0, 30.0}) {
            const double k = 2 * pi / wave, radius = 2.4;
            const auto path = curve(3 * wave, 0.05, [&](double x) { return Vec2{x, height * std::sin(k * x)}; });
            double least = 0, most = 0;
            for (double x = 0; x < 3 * wave; x += 0.001) {
                const double slope = height * k * std::cos(k * x), bend = height * k * k * std::abs(std::sin(k * x));
                const double bent = bend / std::pow(1 + slope * slope, 1.5), l = 0.001 * std::hypot(1, slope);
                least += bent * radius > 1.1 ? l : 0;
                most += bent * radius > 0.9 ? l : 0;
            }
            const auto t = measured({paths::span(path)}, radius);
            EXPECT_GE(t.length, least - 6 * 0.2) << height << " " << wave;
            EXPECT_LE(t.length, most + 6 * 0.2) << height << " " << wave;
        }
}

// Ripples of a fiftieth of a spacing are nothing, at any length of wave; of a tenth they are, if they are short.
TEST(Tight, RipplesAreNothing) {
    for (const double spacing : {0.4, 1.0, 3.0})
        for (const double wave : {0.2, 0.25, 0.5, 0.77, 1.0, 2.0})
            for (const double limit : {0.45 * spacing, 2.4 * spacing}) {
                const auto ripple = [&](double height) {
                    return curve(20 * spacing, wave * spacing / 2, [=](double x) {
                        const bool up = std::lround(2 * x / (wave * spacing)) % 2 == 0;
                        return Vec2{x, (up ? 1 : -1) * height * spacing};
                    });
                };
                EXPECT_EQ(measured({paths::span(ripple(0.0199))}, limit, spacing).length, 0) << wave << " " << limit;
                if (wave == 1.0) {
                    EXPECT_GT(measured({paths::span(ripple(0.1))}, limit, spacing).length, 5 * spacing);
                }
            }
}

TEST(Tight, AsBruteForceSays) {
    std::uint64_t state = 5;
    const auto random = [&] { return next_share(state); };
    for (int round = 0; round < 30; ++round) {
        std::vector<Vec3> path{{0, 0, 0}};
        double heading = 0;
        for (int i = 0; i < 200; ++i) { // arcs, corners and straight stretches
            heading += random() < 0.1 ? 4 * (random() - 0.5) : 0.4 * (random() - 0.5);
            const double l = 0.02 + 0.6 * random();
            path.push_back(path.back() + Vec3{l * std::cos(heading), l * std::sin(heading), 0});
        }
        for (const double radius : {0.45, 2.4}) {
            const double wanted = by_brute_force(path, radius, 1);
            EXPECT_NEAR(measured({paths::span(path)}, radius).length, wanted, 0.02 * wanted + 1) << round;
        }
    }
}

// The role takes nothing from what is tight.
TEST(Tight, RolesDoNotCount) {
    const auto all = hook(1, 0.1);
    const auto plain = measured({paths::span(all)}, 2.4);
    EXPECT_GT(plain.length, 3);
    EXPECT_EQ(measured({paths::span(all, 1, paths::Role::hairpin)}, 2.4).length, plain.length);
}

} // namespace
} // namespace filum::metrics::surface
