// Segments in the plane: nearest points, distances, crossings.
#pragma once

#include "geom/vec.hpp"

#include <optional>

namespace filum::geom {

// Parameter in [0, 1] of the point of segment a-b nearest to p; 0 for a segment without length.
inline double nearest_parameter(Vec2 a, Vec2 b, Vec2 p) {
    const Vec2 d = b - a;
    const double l2 = norm2(d);
    return l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0.0;
}

inline double nearest_parameter(Vec3 a, Vec3 b, Vec3 p) {
    const Vec3 d = b - a;
    const double l2 = norm2(d);
    return l2 > 0 ? std::clamp(dot(p - a, d) / l2, 0.0, 1.0) : 0.0;
}

inline Vec2 nearest_point(Vec2 a, Vec2 b, Vec2 p) { return lerp(a, b, nearest_parameter(a, b, p)); }

inline double point_segment_distance(Vec2 a, Vec2 b, Vec2 p) { return distance(nearest_point(a, b, p), p); }

// Whether the open segments a-b and c-d cross in one point; touching ends and collinear overlap do not count.
inline bool cross_properly(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    const auto apart = [](double s, double t) { return (s > 0 && t < 0) || (s < 0 && t > 0); };
    return apart(orient(a, b, c), orient(a, b, d)) && apart(orient(c, d, a), orient(c, d, b));
}

// The intersection of the ray p + t d, t > 0, with the segment lerp(a, b, u).
struct RayHit {
    double t, u;
};
inline std::optional<RayHit> ray_parameters(Vec2 p, Vec2 d, Vec2 a, Vec2 b) {
    const Vec2 e = b - a, f = a - p;
    const double det = cross(d, e);
    if (det == 0) return std::nullopt;
    const double t = cross(f, e) / det, u = cross(f, d) / det;
    if (t <= 0 || u < 0 || u > 1) return std::nullopt;
    return RayHit{t, u};
}

// Distance between the segments a-b and c-d; 0 if they cross.
inline double segment_distance(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
    if (cross_properly(a, b, c, d)) return 0;
    return std::min({point_segment_distance(a, b, c), point_segment_distance(a, b, d), point_segment_distance(c, d, a),
                     point_segment_distance(c, d, b)});
}

} // namespace filum::geom
