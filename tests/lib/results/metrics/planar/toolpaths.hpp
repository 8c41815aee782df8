// Small toolpaths whose figures are known in advance.
#pragma once

#include "metrics/planar/beads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace filum::metrics::planar {

inline toolpath::Span bead(std::vector<geom::Vec3> points, double width = 0.4, double height = 0.2,
                           std::uint32_t layer = 0, std::uint32_t region = 0) {
    return {toolpath::Role::bead, 0, layer, region, std::move(points), {width}, {height}};
}

inline toolpath::Span travel(geom::Vec3 a, geom::Vec3 b) { return {toolpath::Role::travel, 0, 0, 0, {a, b}, {}, {}}; }

inline polygon::Region region(std::uint32_t id, std::uint32_t layer, polygon::Loops loops, double height = 0.2) {
    polygon::Region r;
    r.id = id;
    r.layer = layer;
    r.height = height;
    r.z = (layer + 1) * height;
    r.area = polygon::signed_area(loops);
    r.loops = std::move(loops);
    return r;
}

inline polygon::Loops box(double x0, double y0, double x1, double y1) {
    polygon::Loops out;
    const std::vector<Vec2> p{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    out.add(p);
    return out;
}

inline polygon::Loops disc(Vec2 centre, double radius, int n = 720) {
    polygon::Loops out;
    for (int k = 0; k < n; ++k) {
        const double a = 2 * std::numbers::pi * k / n;
        out.points.push_back({centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)});
    }
    out.close();
    return out;
}

// Parallel lines along x that fill [0, w] x [0, h] at the pitch, as one zigzag if `joined`.
inline std::vector<toolpath::Span> lines(double w, double h, double pitch, double width, double z,
                                         std::uint32_t layer) {
    std::vector<toolpath::Span> out;
    for (double y = pitch / 2; y < h; y += pitch) out.push_back(bead({{0, y, z}, {w, y, z}}, width, 0.2, layer));
    return out;
}

} // namespace filum::metrics::planar
