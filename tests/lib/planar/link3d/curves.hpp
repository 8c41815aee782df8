// Closed curves that fill: what a fill makes of simple shapes, written down directly.
#pragma once

#include "geom/segment.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <functional>
#include <vector>

namespace filum::link3d::test {

using geom::Vec2;
using toolpath::Curve;

inline constexpr double kWidth = 0.4;

// A numbers generator with the same numbers everywhere.
struct Random {
    std::uint64_t state;
    double operator()() { // [0, 1)
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state >> 11) / 9007199254740992.0;
    }
};

// A comb: `rows` (even) lanes of length `length`, joined in pairs, and a spine on the left; its corner is at `at`.
inline Curve comb(Vec2 at, double length, int rows, double turn = 0) {
    Curve c{true, {}, {kWidth}};
    for (int k = 0; k < rows; ++k) {
        const double y = k * kWidth, left = k == 0 || k == rows - 1 ? 0 : kWidth;
        const Vec2 a{left, y}, b{length, y};
        for (const Vec2 p : k % 2 == 0 ? std::vector{a, b} : std::vector{b, a})
            c.points.push_back(
                at + Vec2{p.x * std::cos(turn) - p.y * std::sin(turn), p.x * std::sin(turn) + p.y * std::cos(turn)});
    }
    return c;
}

// Square rings around `at`, each joined to the next inner one by a bridge, on the right and on the left in turn.
inline Curve rings(Vec2 at, double radius, int count) {
    Curve c{true, {}, {kWidth}};
    const double h = kWidth / 2;
    const std::function<void(double, double, int)> ring = [&](double r, double s, int left) {
        for (const Vec2 p : {Vec2{s * r, h}, Vec2{s * r, r}, Vec2{-s * r, r}}) c.points.push_back(at + p);
        if (left > 1) {
            c.points.push_back(at + Vec2{-s * r, h});
            ring(r - kWidth, -s, left - 1);
            c.points.push_back(at + Vec2{-s * r, -h});
        }
        for (const Vec2 p : {Vec2{-s * r, -r}, Vec2{s * r, -r}, Vec2{s * r, -h}}) c.points.push_back(at + p);
    };
    ring(radius, 1, count);
    return c;
}

inline Curve circle(Vec2 at, double radius, int points) {
    Curve c{true, {}, {kWidth}};
    for (int i = 0; i < points; ++i) {
        const double a = 2 * 3.14159265358979 * i / points;
        c.points.push_back(at + Vec2{radius * std::cos(a), radius * std::sin(a)});
    }
    return c;
}

// Points at most `step` mm apart, and a width of its own for each.
inline Curve refined(const Curve& c, double step, Random& random) {
    Curve out{c.closed, {}, {}};
    for (std::size_t i = 0; i < c.points.size(); ++i) {
        const Vec2 a = c.points[i], b = c.points[(i + 1) % c.points.size()];
        const int n =
            c.closed || i + 1 < c.points.size() ? static_cast<int>(std::ceil(geom::distance(a, b) / step)) : 1;
        for (int k = 0; k < n; ++k) {
            out.points.push_back(geom::lerp(a, b, static_cast<double>(k) / n));
            out.width.push_back(kWidth * (0.9 + 0.2 * random()));
        }
    }
    return out;
}

} // namespace filum::link3d::test
