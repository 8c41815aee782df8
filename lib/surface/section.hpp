// Where things meet a surface: planes, points near it.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

// A straight line within one triangle, borders included; a point if both ends are the same.
struct Segment {
    std::uint32_t triangle = 0;
    Vec3 a, b; // mm; in the triangle's plane
};

struct Plane {
    Vec3 normal;       // any length but 0
    double offset = 0; // of the points p of the plane: dot(normal, p) = offset
};

inline constexpr double kInPlane = 1e-9; // of the box's diagonal: what is nearer to a plane lies in it

// Per vertex its distance from the plane, mm, positive where the normal points; 0 if it lies in it.
std::vector<double> sides(const Surface& s, const Plane& plane);

// The lines that the plane cuts out of the surface, by triangles; an edge that lies in the plane comes once.  The side
// that the normal points to lies to their left, seen from the side that the surface faces.
std::vector<Segment> section(const Surface& s, const Plane& plane);

// mm from `p` to the side of half-edge `h`, its ends included.
double distance_to_side(const Surface& s, std::uint32_t h, const Vec3& p);

// The point of a triangle, borders included, that is nearest to `p`.
Vec3 nearest_in(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);
Vec3 nearest_in(const Surface& s, std::uint32_t triangle, const Vec3& p);

// The point of the surface nearest to `p`, as a segment without length; the first triangle of equals.
Segment nearest(const Surface& s, const Vec3& p);

} // namespace filum::surface
