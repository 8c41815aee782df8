#include "stressfield/triangle.hpp"

namespace filum::stressfield {

namespace {

std::vector<Box3> boxes_of(std::span<const Vec3> points, std::span<const Triangle> triangles) {
    std::vector<Box3> out(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const auto v : triangles[t]) out[t].add(points[v]);
    return out;
}

} // namespace

Vec3 across(const Vec3& n) {
    const Vec3 a{std::abs(n.x), std::abs(n.y), std::abs(n.z)};
    const Vec3 least = a.x <= a.y && a.x <= a.z ? Vec3{1, 0, 0} : a.y <= a.z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    const Vec3 u = cross(n, least);
    return (1 / norm(u)) * u;
}

// Ericson, Real-Time Collision Detection, 5.1.5.
std::array<double, 3> nearest_weights(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = dot(ab, ap), d2 = dot(ac, ap);
    if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
    const double d3 = dot(ab, bp), d4 = dot(ac, bp);
    if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {1 - d1 / (d1 - d3), d1 / (d1 - d3), 0};
    const double d5 = dot(ab, cp), d6 = dot(ac, cp);
    if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {1 - d2 / (d2 - d6), 0, d2 / (d2 - d6)};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
        const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return {0, 1 - w, w};
    }
    const double f = 1 / (va + vb + vc);
    return {1 - vb * f - vc * f, vb * f, vc * f};
}

TriangleTree::TriangleTree(std::span<const Vec3> points, std::span<const Triangle> triangles)
    : points_(points), triangles_(triangles), tree_(boxes_of(points, triangles)) {}

void TriangleTree::improve(TriangleHit& hit, std::uint32_t triangle, const Vec3& p) const {
    const auto& [i, j, k] = triangles_[triangle];
    const Vec3 a = points_[i], b = points_[j], c = points_[k];
    const auto w = nearest_weights(a, b, c, p);
    const Vec3 at = w[0] * a + w[1] * b + w[2] * c;
    const double d = distance(p, at);
    if (d < hit.distance || (d == hit.distance && triangle < hit.triangle)) hit = {triangle, d, w, at};
}

} // namespace filum::stressfield
