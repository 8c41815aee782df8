// Rays from the outline to the medial axis, and their points by lane coordinate. Private to lib/planar/fill/rings.
#pragma once

#include "fill/rings/beading.hpp"

#include <cmath>
#include <optional>

namespace filum::fill::rings {

// The ray to the point with parameter `t` of half-edge h (0 at its first node), within h's part of the outline.
struct Ray {
    const Beading* b;
    std::uint32_t i, j; // nodes at both ends of h
    double t, radius;
    Vec2 foot, top;

    Ray(const Beading& beading, std::uint32_t h, double share) : b(&beading), t(share) {
        const MedialAxis& axis = beading.axis;
        i = axis.from[h];
        j = axis.to(h);
        foot = t == 0 ? axis.foot[h] : geom::lerp(axis.foot[h], axis.last_foot(h), t);
        top = t == 0 ? axis.node[i] : geom::lerp(axis.node[i], axis.node[j], t);
        radius = t == 0 ? axis.radius[i] : geom::distance(foot, top);
    }
    [[nodiscard]] double depth(double f) const {
        return t == 0 ? b->depth(i, f) : std::lerp(b->depth(i, f), b->depth(j, f), t);
    }
    [[nodiscard]] Vec2 point(double f) const {
        return radius > 0 ? foot + std::min(1.0, depth(f) / radius) * (top - foot) : top;
    }
};

// The parameter of h at which the axis has lane coordinate f; none if it does not.
inline std::optional<double> share_at(const Beading& b, std::uint32_t h, double f) {
    const std::uint32_t i = b.axis.from[h], j = b.axis.to(h);
    const double at_i = b.axis.radius[i] - b.depth(i, f), at_j = b.axis.radius[j] - b.depth(j, f);
    if (at_i == at_j || (at_i > 0) == (at_j > 0)) return std::nullopt;
    return at_i / (at_i - at_j);
}

// If h belongs to a vertex of the outline: calls put(point) for points strictly between p and q on the arc around that
// vertex, such that chords deviate by at most `tolerance` mm.
template <class Put>
void each_on_arc(const MedialAxis& axis, std::uint32_t h, Vec2 p, Vec2 q, double tolerance, Put&& put) {
    const Vec2 foot = axis.foot[h];
    if (axis.last_foot(h) != foot) return;
    const Vec2 a = p - foot, b = q - foot;
    const double ra = geom::norm(a), rb = geom::norm(b), half = std::max(0.0, 1 - tolerance / std::max(ra, rb));
    if (dot(a, b) >= (2 * half * half - 1) * ra * rb) return; // by cosines: no more than a step, as on most rays
    const double angle = std::atan2(cross(a, b), dot(a, b)), step = 2 * std::acos(half);
    if (std::abs(angle) <= step) return;
    const int n = static_cast<int>(std::ceil(std::abs(angle) / step));
    for (int k = 1; k < n; ++k) {
        const double t = static_cast<double>(k) / n, r = std::lerp(ra, rb, t) / ra;
        const double c = std::cos(t * angle), s = std::sin(t * angle);
        put(foot + r * Vec2{c * a.x - s * a.y, s * a.x + c * a.y});
    }
}

} // namespace filum::fill::rings
