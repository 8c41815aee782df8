// How the part is turned on the machine: a rigid turn that brings the tool's axes within what the machine tilts.
#pragma once

#include "machine/profile.hpp"
#include "toolpath/path.hpp"

#include <array>
#include <span>
#include <string>

namespace filum::postproc {

using geom::Vec3;

// About the fixed x, then y, then z axis through the origin, degrees; counter-clockwise seen against the axis.
struct Turning {
    std::array<double, 3> degrees{};
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}; // where the part's axes come to lie
    [[nodiscard]] bool none() const { return degrees == std::array<double, 3>{}; }
    [[nodiscard]] Vec3 operator()(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

Turning turning(const std::array<double, 3>& degrees);

// The least turn that brings `up` (of any length but 0) to point upwards; half a turn about x if it points down.
// Angles are whole multiples of 1e-4 degrees, so that the program's head can say them.
Turning upright(const Vec3& up);

// What the user says: "as-is", "auto", "RX,RY,RZ" (degrees) or "up:X,Y,Z".
struct Orient {
    bool automatic = false;
    Turning turning;
};
Orient parse_orient(const std::string& text); // throws Error(usage)

// The narrowest cone that holds all of `axes` (unit): its axis, and half its angle, rad.  At half pi or beyond no cone
// does.  Ties do not arise: it is unique.  The axis is that of the smallest ball around the points on the unit sphere
// (Gaertner 1999, pivoting on the farthest point).
struct Cone {
    Vec3 axis{0, 0, 1};
    double half = 0;
};
Cone narrowest_cone(std::span<const Vec3> axes);

// `text` for the head of a program: how its numbers' frame lies to the toolpath's.
std::string placed_text(const Turning& turning, const Vec3& shift);

} // namespace filum::postproc
