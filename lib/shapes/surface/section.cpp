#include "surface/section.hpp"

#include <algorithm>
#include <limits>

namespace filum::surface {

namespace {

// The line directed such that the normal's side of the plane is on its left, seen from the side that the surface
// faces.
Segment turned(const Surface& s, const Segment& line, const Plane& plane) {
    const bool wrong = dot(line.b - line.a, cross(plane.normal, normal(s, line.triangle))) < 0;
    return wrong ? Segment{line.triangle, line.b, line.a} : line;
}

} // namespace

std::vector<double> sides(const Surface& s, const Plane& plane) {
    const double size = norm(plane.normal), near = kInPlane * norm(geom::box_of(s.vertices).size());
    std::vector<double> out(s.vertices.size());
    for (std::size_t v = 0; v < out.size(); ++v) {
        out[v] = (dot(plane.normal, s.vertices[v]) - plane.offset) / size;
        if (std::abs(out[v]) <= near) out[v] = 0;
    }
    return out;
}

std::vector<Segment> section(const Surface& s, const Plane& plane) {
    const auto side = sides(s, plane);
    std::vector<Segment> out;
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        Vec3 ends[2];
        int found = 0;
        bool along = false;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t h = 3 * t + k, a = s.tail(h), b = s.head(h);
            if (side[a] == 0 && side[b] == 0) {
                along = true;
                if (s.twin[h] == kNone || h < s.twin[h])
                    out.push_back(turned(s, {t, s.vertices[a], s.vertices[b]}, plane));
            }
            if (found == 2) continue;
            if (side[a] == 0)
                ends[found++] = s.vertices[a];
            else if (side[a] * side[b] < 0)
                ends[found++] = s.vertices[a] + side[a] / (side[a] - side[b]) * (s.vertices[b] - s.vertices[a]);
        }
        if (found == 2 && !along) out.push_back(turned(s, {t, ends[0], ends[1]}, plane));
    }
    return out;
}

// Nearest point inside the triangle or on a side (Ericson, Real-Time Collision Detection, 5.1.5).
double distance_to_side(const Surface& s, std::uint32_t h, const Vec3& p) {
    const Vec3 &a = s.vertices[s.tail(h)], d = s.vertices[s.head(h)] - a;
    return distance(p, a + std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) * d);
}

Vec3 nearest_in(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
                 d6 = dot(ac, cp);
    if (d1 <= 0 && d2 <= 0) return a;
    if (d3 >= 0 && d4 <= d3) return b;
    if (d6 >= 0 && d5 <= d6) return c;
    const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
    const double f = 1 / (va + vb + vc);
    return a + vb * f * ab + vc * f * ac;
}

Vec3 nearest_in(const Surface& s, std::uint32_t triangle, const Vec3& p) {
    const auto& [a, b, c] = s.triangles[triangle];
    return nearest_in(s.vertices[a], s.vertices[b], s.vertices[c], p);
}

Segment nearest(const Surface& s, const Vec3& p) {
    Segment out;
    double least = std::numeric_limits<double>::infinity();
    for (std::uint32_t t = 0; t < s.triangles.size(); ++t) {
        const Vec3 q = nearest_in(s, t, p);
        const double d = distance(p, q);
        if (d < least) {
            least = d;
            out = {t, q, q};
        }
    }
    return out;
}

} // namespace filum::surface
