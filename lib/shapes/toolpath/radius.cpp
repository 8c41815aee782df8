#include "toolpath/radius.hpp"

#include "geom/segment.hpp"

#include <cmath>
#include <limits>

namespace filum::toolpath {

namespace {

using geom::Vec2;

// The point `s` mm from vertex i along the line, forwards or backwards.
Vec2 along(std::span<const Vec2> line, bool closed, std::size_t i, bool forwards, double s) {
    const std::size_t n = line.size();
    for (std::size_t k = 0; k < n; ++k) {
        if (!closed && i == (forwards ? n - 1 : 0)) break;
        const std::size_t next = forwards ? (i + 1 == n ? 0 : i + 1) : (i == 0 ? n - 1 : i - 1);
        const double l = geom::distance(line[i], line[next]);
        if (l >= s && l > 0) return geom::lerp(line[i], line[next], s / l);
        s -= l;
        i = next;
    }
    return line[i];
}

} // namespace

double radius_at(std::span<const Vec2> line, bool closed, std::size_t i, double scale) {
    const std::size_t n = line.size();
    const Vec2 u = line[i] - line[(i + n - 1) % n], v = line[(i + 1) % n] - line[i];
    const double straight = std::numeric_limits<double>::infinity();
    if (std::abs(geom::cross(u, v)) < 1e-6 * geom::norm(u) * geom::norm(v) && dot(u, v) > 0) return straight;
    const Vec2 a = along(line, closed, i, false, scale), b = line[i], c = along(line, closed, i, true, scale);
    const double twice_area = std::abs(geom::orient(a, b, c));
    if (twice_area <= 1e-9 * geom::norm2(c - a) && dot(b - a, c - b) > 0) return straight;
    if (twice_area == 0) return 0; // reversal
    return geom::distance(a, b) * geom::distance(b, c) * geom::distance(c, a) / (2 * twice_area);
}

} // namespace filum::toolpath
