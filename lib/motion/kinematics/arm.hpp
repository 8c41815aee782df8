// Robot arms with six rotary axes in series.
#pragma once

#include "geom/frame.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace filum::kinematics {

inline constexpr std::size_t kAxes = 6;
using Posture = std::array<double, kAxes>; // rad, axis 1 first

struct Axis {
    geom::Vec3 direction{0, 0, 1}, point; // unit; mm: a point of the axis in the robot's base while all axes are at 0
    double min = 0, max = 0;              // rad
    double speed = 1;                     // rad/s, at most
};

// The kinds of arms, by how their inverse kinematics are solved.
enum class Build : std::uint8_t {
    wrist,    // the last three axes meet in a point, the second and third are parallel: industrial robots
    parallel, // the second, third and fourth axis are parallel, the last two meet: Universal Robots and similar arms
    general,  // any other, by iteration
};

// An arm as a product of exponentials (Brockett 1984): axis k rotates everything behind it about its line.
struct Arm {
    std::array<Axis, kAxes> axes;
    geom::Frame flange; // while all axes are at 0
    Build build = Build::general;
    geom::Vec3 centre; // mm, while all axes are at 0: where the last three axes meet, or the last two
    double reach = 0;  // mm: upper bound on the distance of the flange from axis 2's point
    double ahead = 1;  // 1 or -1: on which side of axis 1 the arm is while all axes are at 0
};

// The arm with these axes and this flange; the other members are computed.
Arm arm(const std::array<Axis, kAxes>& axes, const geom::Frame& flange);

// A row of a Denavit-Hartenberg table (1955, each frame behind its axis): rotation about z by the axis' angle and
// `theta`, translation along z by `d` and along x by `a`, rotation about x by `alpha`.
struct DhRow {
    double a = 0, d = 0, alpha = 0, theta = 0; // mm, rad
    double sign = 1;                           // -1: the axis counts in the opposite direction
};
Arm arm(const std::array<DhRow, kAxes>& rows, const std::array<Axis, kAxes>& limits, const geom::Frame& flange);

geom::Frame forward(const Arm& arm, const Posture& posture); // of the flange, in the robot's base

// Why a frame cannot be reached.
struct Shortfall {
    std::size_t axis = 0; // from 0: 0 shoulder, 2 elbow, 4 wrist
    double length = 0;    // mm beyond what it reaches; 0 if unknown
};

// Singularities: where two configurations coincide and an axis would need infinite speed.
enum class Singular : std::uint8_t { shoulder, elbow, wrist };
inline constexpr std::array<const char*, 3> kSingularNames{"shoulder", "elbow", "wrist"};
struct Nearness {
    Singular which = Singular::wrist;
    double angle = 0; // rad
};

// The nearest singularity and the arm's angle from it. Shoulder: the wrist's centre is on axis 1; the angle is that
// under which its distance from the axis is seen at the arm's reach. Elbow: the arm is stretched or folded. Wrist:
// axes 4 and 6 are parallel; the angle between them. For arms of general geometry it is the arc sine of the Jacobian's
// least singular value, with lengths in units of the reach, reported as "wrist".
Nearness nearness(const Arm& arm, const Posture& posture);

// The configuration of an arm; constant for general geometry.
struct Configuration {
    bool behind = false;    // the wrist is behind axis 1, seen in the forward direction of axis 2
    bool bent_down = false; // axis 3 is on the other side of the straight arm
    bool flipped = false;   // axis 5 is negative; for parallel axes: the wrist is on the other side of straight
    friend bool operator==(const Configuration&, const Configuration&) = default;
};
Configuration configuration(const Arm& arm, const Posture& posture);

// All postures that put the flange at `flange`, with angles in (-pi, pi]; none if it is out of reach. Limits are not
// checked. At a singularity a free axis stays as in `near`. For general geometry only the solutions that iteration
// finds from `near` and from a fixed set of starts. Accurate to 1e-6 mm and 1e-8 rad. `lack` is set to the reason if
// there is none.
std::vector<Posture> inverse(const Arm& arm, const geom::Frame& flange, const Posture& near, Shortfall* lack = nullptr);

// The posture to which iteration from `from` converges in at most `steps` steps; none if it does not. Angles are not
// wrapped.
std::optional<Posture> refined(const Arm& arm, const geom::Frame& flange, const Posture& from, int steps);

// The angles of `posture` plus multiples of 2 pi that bring them nearest to `near`.
Posture unwrapped(const Posture& posture, const Posture& near);

// Greatest difference of any axis, rad.
double apart(const Posture& a, const Posture& b);

} // namespace filum::kinematics
