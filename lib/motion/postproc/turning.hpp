// The turn of the part on the machine: a rotation that brings the tool axes within the tilts of the machine.
#pragma once

#include "machine/profile.hpp"
#include "toolpath/path.hpp"

#include <array>
#include <span>
#include <string>

namespace filum::postproc {

using geom::Vec3;

// A rotation about the fixed x, then y, then z axis through the origin, in degrees; counter-clockwise seen against the
// axis.
struct Turning {
    std::array<double, 3> degrees{};
    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}; // the part's axes after the turn
    [[nodiscard]] bool none() const { return degrees == std::array<double, 3>{}; }
    [[nodiscard]] Vec3 operator()(const Vec3& v) const { return v.x * x + v.y * y + v.z * z; }
};

Turning turning(const std::array<double, 3>& degrees);

// The smallest turn that makes `up` point upwards; half a turn about x if it points down.  `up` must not be 0.  Angles
// are whole multiples of 1e-4 degrees, so that the head of the program can give them exactly.
Turning upright(const Vec3& up);

// The option --orient: "as-is", "auto", "RX,RY,RZ" (degrees) or "up:X,Y,Z".
struct Orient {
    bool automatic = false;
    Turning turning;
};
Orient parse_orient(const std::string& text); // throws Error(usage)

// The narrowest cone that holds all of `axes` (unit): its axis, and half its angle, rad.  A half angle of pi / 2 or
// more means that there is none.  The cone is unique, so there are no ties.  The axis is that of the smallest ball
// around the points on the unit sphere (Gaertner 1999, pivoting on the farthest point).
struct Cone {
    Vec3 axis{0, 0, 1};
    double half = 0;
};
Cone narrowest_cone(std::span<const Vec3> axes);

// A line for the head of a program: the position of the program's frame in the toolpath's.
std::string placed_text(const Turning& turning, const Vec3& shift);

} // namespace filum::postproc
