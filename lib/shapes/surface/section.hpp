// Plane sections of a surface, and its points nearest to a place.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

// A straight line within one triangle, borders included; a point if both ends are equal.
struct Segment {
    std::uint32_t triangle = 0;
    Vec3 a, b; // mm; in the triangle's plane
};

struct Plane {
    Vec3 normal;       // of any length except 0
    double offset = 0; // points p of the plane satisfy dot(normal, p) = offset
};

inline constexpr double kInPlane = 1e-9; // box diagonals: points nearer than this to a plane are on it

// Per vertex its signed distance from the plane, mm, positive on the normal's side; 0 if it is on the plane.
std::vector<double> sides(const Surface& s, const Plane& plane);

// The section of the surface with the plane, by triangles; an edge in the plane is contained once. The normal's side
// is on the left of the lines, seen from the side that the surface faces.
std::vector<Segment> section(const Surface& s, const Plane& plane);

// Distance from `p` to the side of half-edge `h`, ends included, mm.
double distance_to_side(const Surface& s, std::uint32_t h, const Vec3& p);

// The point of a triangle, borders included, that is nearest to `p`.
Vec3 nearest_in(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);
Vec3 nearest_in(const Surface& s, std::uint32_t triangle, const Vec3& p);

// The point of the surface nearest to `p`, as a segment of length 0; ties: the first triangle.
Segment nearest(const Surface& s, const Vec3& p);

} // namespace filum::surface
