// Regions to fill: random ones, and the kinds that break simple algorithms.
#pragma once

#include "geom/segment.hpp"
#include "polygon/clip.hpp"

#include <cmath>
#include <numbers>
#include <random>

namespace filum::test {

using geom::Vec2;
using polygon::Loops;

inline constexpr double kWidth = 0.4; // mm, of beads

inline Loops rectangle(double x0, double y0, double x1, double y1) {
    Loops out;
    out.add(std::vector<Vec2>{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
    return out;
}

inline Loops disc(Vec2 c, double r, int n = 60) {
    std::vector<Vec2> loop;
    for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * k / n;
        loop.push_back(c + r * Vec2{std::cos(a), std::sin(a)});
    }
    Loops out;
    out.add(loop);
    return out;
}

// Two rooms joined by a corridor of the given thickness.
inline Loops dumbbell(double corridor) {
    auto area = polygon::unite(rectangle(0, 0, 6, 6), rectangle(14, 0, 20, 6));
    return polygon::unite(area, rectangle(5, 3 - corridor / 2, 15, 3 + corridor / 2));
}

// A spine with teeth that taper to a point.
inline Loops comb(int teeth, double length) {
    Loops area = rectangle(0, 0, 3.0 * teeth, 2);
    for (int k = 0; k < teeth; ++k) {
        Loops tooth;
        tooth.add(std::vector<Vec2>{{3.0 * k + 0.5, 1.9}, {3.0 * k + 2.0, 1.9}, {3.0 * k + 1.2, 2 + length}});
        area = polygon::unite(area, tooth);
    }
    return area;
}

// A plate with a grid of round holes, `wall` apart.
inline Loops sieve(int n, double hole, double wall) {
    const double pitch = 2 * hole + wall, side = n * pitch + wall;
    Loops area = rectangle(0, 0, side, side), holes;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const auto h = disc({wall + hole + i * pitch, wall + hole + j * pitch}, hole, 24);
            holes.add(h[0]);
        }
    return polygon::subtract(area, holes);
}

// The largest connected part of a random union of discs and rectangles, less some holes.
inline Loops random_region(std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double a, double b) { return a + (b - a) * (random() / 4294967296.0); };
    Loops area, holes;
    for (int k = 0; k < 6; ++k) {
        const Vec2 c{uniform(0, 12), uniform(0, 12)};
        const double r = uniform(0.3, 4);
        const Vec2 size{uniform(0.2, 9), uniform(0.2, 3)};
        const int corners = 7 + static_cast<int>(uniform(0, 40));
        area = polygon::unite(area, k % 2 == 0 ? disc(c, r, corners) : rectangle(c.x, c.y, c.x + size.x, c.y + size.y));
    }
    for (int k = 0; k < 4; ++k) {
        const Vec2 c{uniform(0, 12), uniform(0, 12)};
        holes.add(disc(c, uniform(0.2, 1.5), 16)[0]);
    }
    const auto parts = polygon::split(polygon::simplify(polygon::subtract(area, polygon::unite(holes)), 0.001));
    std::size_t largest = 0;
    for (std::size_t i = 0; i < parts.part.size(); ++i)
        if (polygon::signed_area(parts.part[i]) > polygon::signed_area(parts.part[largest])) largest = i;
    return parts.part[largest];
}

} // namespace filum::test
