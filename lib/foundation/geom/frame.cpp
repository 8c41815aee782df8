#include "geom/frame.hpp"

#include <algorithm>
#include <cmath>

namespace filum::geom {

Vec3 turned(const Vec3& v, const Vec3& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return c * v + s * cross(axis, v) + (1 - c) * dot(axis, v) * axis;
}

Rotation about(const Vec3& axis, double angle) {
    return {turned({1, 0, 0}, axis, angle), turned({0, 1, 0}, axis, angle), turned({0, 0, 1}, axis, angle)};
}

std::array<double, 3> euler_zyx(const Rotation& r) {
    constexpr double upright = 1e-9; // horizontal part of a unit vector below which only A + C or A - C is determined
    const double level = std::hypot(r.x.x, r.x.y);
    const double b = std::atan2(-r.x.z, level);
    if (level < upright) return {std::atan2(-r.y.x, r.y.y), b, 0};
    return {std::atan2(r.x.y, r.x.x), b, std::atan2(r.y.z, r.z.z)};
}

Rotation from_euler_zyx(double a, double b, double c) {
    return about({0, 0, 1}, a) * about({0, 1, 0}, b) * about({1, 0, 0}, c);
}

// Divides by the largest of the four components, so that no difference cancels (Shepperd 1978).
std::array<double, 4> quaternion(const Rotation& r) {
    const double t = r.x.x + r.y.y + r.z.z;
    const std::array<double, 4> squares{1 + t, 1 + 2 * r.x.x - t, 1 + 2 * r.y.y - t, 1 + 2 * r.z.z - t};
    const auto k = std::max_element(squares.begin(), squares.end()) - squares.begin();
    const double yz = r.y.z - r.z.y, zx = r.z.x - r.x.z, xy = r.x.y - r.y.x;
    const double a = r.x.y + r.y.x, b = r.z.x + r.x.z, c = r.y.z + r.z.y;
    const std::array<std::array<double, 4>, 4> rows{
        {{squares[0], yz, zx, xy}, {yz, squares[1], a, b}, {zx, a, squares[2], c}, {xy, b, c, squares[3]}}};
    auto q = rows[static_cast<std::size_t>(k)];
    const double size = std::hypot(std::hypot(q[0], q[1]), std::hypot(q[2], q[3])) * (q[0] < 0 ? -1 : 1);
    for (double& v : q) v /= size;
    return q;
}

std::array<double, 3> rotation_vector(const Rotation& r) {
    const auto q = quaternion(r);
    const double s = std::sqrt(q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    const double f = s > 1e-12 ? 2 * std::atan2(s, q[0]) / s : 2;
    return {f * q[1], f * q[2], f * q[3]};
}

Rotation rotation_of(const Vec3& z, const Vec3& x) {
    const Vec3 up = 1 / norm(z) * z;
    const Vec3 across = x - dot(x, up) * up;
    const Vec3 side = 1 / norm(across) * across;
    return {side, cross(up, side), up};
}

} // namespace filum::geom
