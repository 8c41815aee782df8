// Points and vectors in the plane and in space, mm.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::geom {

struct Vec2 {
    double x = 0, y = 0;
    friend bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
constexpr double dot(Vec2 a, Vec2 b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vec2 a, Vec2 b) { return a.x * b.y - a.y * b.x; }
constexpr double norm2(Vec2 a) { return dot(a, a); }
inline double norm(Vec2 a) { return std::sqrt(norm2(a)); }
inline double distance(Vec2 a, Vec2 b) { return norm(b - a); }
constexpr Vec2 lerp(Vec2 a, Vec2 b, double t) { return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; }
constexpr Vec2 left_of(Vec2 a) { return {-a.y, a.x}; } // rotated by +90 degrees

// Twice the signed area of the triangle a b c: positive if c is left of a -> b.
constexpr double orient(Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); }

struct Vec3 {
    double x = 0, y = 0, z = 0;
    friend bool operator==(const Vec3&, const Vec3&) = default;
    [[nodiscard]] constexpr Vec2 xy() const { return {x, y}; }
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator*(double s, Vec3 a) { return {s * a.x, s * a.y, s * a.z}; }
constexpr double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
constexpr double norm2(Vec3 a) { return dot(a, a); }
inline double norm(Vec3 a) { return std::sqrt(norm2(a)); }
inline double distance(Vec3 a, Vec3 b) { return norm(b - a); }
// Angle in [0, pi], rad; 0 if a vector has no length.
inline double angle(Vec3 a, Vec3 b) { return std::atan2(norm(cross(a, b)), dot(a, b)); }
// The vector scaled to length 1; `otherwise` if it has no length.
inline Vec3 unit(Vec3 v, Vec3 otherwise) {
    const double l = norm(v);
    return l > 0 ? (1 / l) * v : otherwise;
}
constexpr double coordinate(Vec3 v, int axis) { return axis == 0 ? v.x : axis == 1 ? v.y : v.z; }
// The axis of the largest component, the first of equals. Precondition: components are at least 0.
constexpr int longest_axis(Vec3 v) { return v.x >= v.y && v.x >= v.z ? 0 : v.y >= v.z ? 1 : 2; }

// An axis-aligned box; empty until something is added.
struct Box3 {
    Vec3 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
            std::numeric_limits<double>::infinity()};
    Vec3 hi{-1.0 * lo};
    void add(Vec3 p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    void add(const Box3& b) {
        lo = {std::min(lo.x, b.lo.x), std::min(lo.y, b.lo.y), std::min(lo.z, b.lo.z)};
        hi = {std::max(hi.x, b.hi.x), std::max(hi.y, b.hi.y), std::max(hi.z, b.hi.z)};
    }
    [[nodiscard]] bool empty() const { return lo.x > hi.x; }
    [[nodiscard]] Vec3 size() const { return hi - lo; }
};
template <class Points>
Box3 box_of(const Points& points) {
    Box3 out;
    for (const Vec3& p : points) out.add(p);
    return out;
}
// The box enlarged by `by` on every side.
constexpr Box3 grown(const Box3& b, double by) { return {b.lo - Vec3{by, by, by}, b.hi + Vec3{by, by, by}}; }

constexpr bool meet(const Box3& a, const Box3& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y && a.lo.z <= b.hi.z &&
           b.lo.z <= a.hi.z;
}

// Distance from the box to p; 0 inside.
inline double distance(const Box3& b, Vec3 p) {
    return norm(Vec3{std::max({0.0, b.lo.x - p.x, p.x - b.hi.x}), std::max({0.0, b.lo.y - p.y, p.y - b.hi.y}),
                     std::max({0.0, b.lo.z - p.z, p.z - b.hi.z})});
}

struct Box2 {
    Vec2 lo{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Vec2 hi{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    void add(Vec2 p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
    }
    [[nodiscard]] bool empty() const { return lo.x > hi.x; }
};

inline bool meet(const Box2& a, const Box2& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y;
}

// Squared distance from the box to p; 0 inside.
inline double distance2(const Box2& b, Vec2 p) {
    return norm2(Vec2{std::max({0.0, b.lo.x - p.x, p.x - b.hi.x}), std::max({0.0, b.lo.y - p.y, p.y - b.hi.y})});
}

// Distance between two boxes; 0 if they touch or overlap.
inline double distance(const Box2& a, const Box2& b) {
    const double dx = std::max({0.0, a.lo.x - b.hi.x, b.lo.x - a.hi.x});
    const double dy = std::max({0.0, a.lo.y - b.hi.y, b.lo.y - a.hi.y});
    return std::hypot(dx, dy);
}

} // namespace filum::geom
