// What the tests ask of plans.
#pragma once

#include "surfpath/plan/coverage.hpp"
#include "surfpath/plan/widths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace filum::surfpath {

using namespace plan;

inline double fact(const Plan& plan, const std::string& name) {
    for (const Fact& f : plan.facts)
        if (f.name == name) return f.value;
    ADD_FAILURE() << name;
    return -1;
}

// Share of the surface that the plan's beads cover, if they may be a fifth wider or narrower than 1 mm.
inline double covered_with_widths(const Surface& s, Plan plan) {
    fit_widths(s, plan, {1, 0.2});
    const Coverage found = cover(s, plan, 1);
    return found.covered / found.surface;
}

// The share of the surface within `reach` mm of the path, by samples.

inline double covered(const Surface& s, const Plan& plan, double reach = 0.501) {
    std::vector<std::pair<Vec3, Vec3>> path;
    for (const Stroke& stroke : plan.strokes)
        for (const Section& piece : stroke.sections)
            for (std::size_t i = 1; i < piece.line.size(); ++i) path.emplace_back(piece.line[i - 1], piece.line[i]);
    std::vector<std::vector<std::size_t>> grid(160 * 160);
    const auto cell = [](const Vec3& p, int dx, int dy) {
        const int x = std::clamp(static_cast<int>(p.x + 50) + dx, 0, 159);
        const int y = std::clamp(static_cast<int>(p.y + 50) + dy, 0, 159);
        const int at = 160 * y + x;
        return static_cast<std::size_t>(at);
    };
    for (std::size_t i = 0; i < path.size(); ++i) {
        const double l = distance(path[i].first, path[i].second);
        for (double at = 0; at <= l; at += 0.4)
            grid[cell(path[i].first + (l > 0 ? at / l : 0) * (path[i].second - path[i].first), 0, 0)].push_back(i);
    }
    const auto near = [&](const Vec3& p) {
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy)
                for (const std::size_t i : grid[cell(p, dx, dy)]) {
                    const Vec3 d = path[i].second - path[i].first;
                    const double l2 = dot(d, d);
                    const double t = l2 > 0 ? std::clamp(dot(p - path[i].first, d) / l2, 0.0, 1.0) : 0;
                    if (distance(p, path[i].first + t * d) <= reach) return true;
                }
        return false;
    };
    std::mt19937 random(1);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    double all = 0, in = 0;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const Vec3 &a = s.vertices[s.triangles[t][0]], u = s.vertices[s.triangles[t][1]] - a,
                   v = s.vertices[s.triangles[t][2]] - a;
        const double whole = norm(cross(u, v)) / 2;
        const int samples = std::max(5, static_cast<int>(10 * whole)); // large triangles: ten for each mm2
        const double area = whole / samples;
        for (int k = 0; k < samples; ++k) {
            double x = unit(), y = unit();
            if (x + y > 1) {
                x = 1 - x;
                y = 1 - y;
            }
            all += area;
            in += near(a + x * u + y * v) ? area : 0;
        }
    }
    return in / all;
}

} // namespace filum::surfpath
