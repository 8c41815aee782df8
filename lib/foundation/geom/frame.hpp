// Rotations and rigid frames in space.
#pragma once

#include "geom/vec.hpp"

#include <array>

namespace filum::geom {

// A rotation: the images of the axes, orthonormal and right-handed.
struct Rotation {
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    friend bool operator==(const Rotation&, const Rotation&) = default;
};

constexpr Vec3 operator*(const Rotation& r, const Vec3& v) { return v.x * r.x + v.y * r.y + v.z * r.z; }
constexpr Rotation operator*(const Rotation& a, const Rotation& b) { return {a * b.x, a * b.y, a * b.z}; }
constexpr Rotation inverse(const Rotation& r) {
    return {{r.x.x, r.y.x, r.z.x}, {r.x.y, r.y.y, r.z.y}, {r.x.z, r.y.z, r.z.z}};
}

// `v` rotated by `angle` rad around the unit vector `axis` (Rodrigues).
Vec3 turned(const Vec3& v, const Vec3& axis, double angle);
Rotation about(const Vec3& axis, double angle);

// Angles of rotations around z, then the new y, then the new x, rad: A, B, C of KRL. They equal rotations around the
// fixed x, y, z by C, B, A (roll, pitch and yaw of URDF). Where B is a right angle only A - C or A + C is determined,
// and C is 0.
std::array<double, 3> euler_zyx(const Rotation& r);
Rotation from_euler_zyx(double a, double b, double c);

std::array<double, 4> quaternion(const Rotation& r);      // w, x, y, z; w >= 0
std::array<double, 3> rotation_vector(const Rotation& r); // unit axis times angle in [0, pi], rad

// The rotation with its z axis along `z` and its x axis as near to `x` as possible. Precondition: z and x are not
// parallel.
Rotation rotation_of(const Vec3& z, const Vec3& x);

// A rigid frame: origin and rotation relative to another frame.
struct Frame {
    Rotation turn;
    Vec3 origin; // mm
};

constexpr Vec3 operator*(const Frame& f, const Vec3& p) { return f.origin + f.turn * p; }
constexpr Frame operator*(const Frame& a, const Frame& b) { return {a.turn * b.turn, a * b.origin}; }
constexpr Frame inverse(const Frame& f) {
    const Rotation back = inverse(f.turn);
    return {back, -1.0 * (back * f.origin)};
}

} // namespace filum::geom
