#include "geom/principal_axis.hpp"

#include <cmath>
#include <limits>

namespace filum::geom {

Axis principal_axis(std::span<const Vec2> points) {
    Vec2 mean;
    for (const Vec2 p : points) mean = mean + p;
    mean = (1 / static_cast<double>(points.size())) * mean;
    double xx = 0, xy = 0, yy = 0;
    for (const Vec2 p : points) {
        const Vec2 d = p - mean;
        xx += d.x * d.x;
        xy += d.x * d.y;
        yy += d.y * d.y;
    }
    const double angle = std::atan2(2 * xy, xx - yy) / 2; // in [-90, 90] degrees
    Vec2 direction{std::cos(angle), std::sin(angle)};
    if (direction.x < 1e-6 && direction.y < 0) direction = -1.0 * direction; // vertical up to rounding
    return {mean, direction};
}

std::optional<Vec2> leaves(const Axis& axis, std::span<const Vec2> points) {
    std::optional<Vec2> out;
    double farthest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 a = points[i] - axis.mean, b = points[(i + 1) % points.size()] - axis.mean;
        const double ha = cross(axis.direction, a), hb = cross(axis.direction, b);
        if ((ha > 0) == (hb > 0)) continue;
        const Vec2 at = lerp(a, b, ha / (ha - hb));
        if (dot(at, axis.direction) <= farthest) continue;
        farthest = dot(at, axis.direction);
        out = axis.mean + at;
    }
    return out;
}

} // namespace filum::geom
