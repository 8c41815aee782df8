// Robots: arms of six turning axes, one carried by the other.
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
    geom::Vec3 direction{0, 0, 1}, point; // unit; mm: where it lies in the robot's base while all axes stand at 0
    double min = 0, max = 0;              // rad
    double speed = 1;                     // rad/s, at most
};

// How the ways to stand are found.
enum class Build : std::uint8_t {
    wrist,    // the last three axes meet in a point, the second and third are parallel: industrial robots
    parallel, // the second, third and fourth axis are parallel, the last two meet: Universal Robots and their like
    general,  // any other: by iteration
};

// By a product of exponentials (Brockett 1984): axis k turns all behind it about its line.
struct Arm {
    std::array<Axis, kAxes> axes;
    geom::Frame flange; // while all axes stand at 0
    Build build = Build::general;
    geom::Vec3 centre; // mm, while all axes stand at 0: where the last three axes meet, or the last two
    double reach = 0;  // mm: no place of the flange is farther from axis 2's point
    double ahead = 1;  // 1 or -1: on which side of axis 1 the arm is while all axes stand at 0
};

// Of axes and a flange, with the rest worked out.
Arm arm(const std::array<Axis, kAxes>& axes, const geom::Frame& flange);

// A row of a Denavit-Hartenberg table (1955, each frame behind its axis): turn about z by the axis' angle and `theta`,
// shift along z by `d`, along x by `a`, turn about x by `alpha`.
struct DhRow {
    double a = 0, d = 0, alpha = 0, theta = 0; // mm, rad
    double sign = 1;                           // -1: the axis counts the other way
};
Arm arm(const std::array<DhRow, kAxes>& rows, const std::array<Axis, kAxes>& limits, const geom::Frame& flange);

geom::Frame forward(const Arm& arm, const Posture& posture); // of the flange, in the robot's base

// What a place cannot be stood at for.
struct Lack {
    std::size_t axis = 0; // counted from 0: 0 shoulder, 2 elbow, 4 wrist
    double length = 0;    // mm beyond what it reaches; 0 if nobody knows
};

// How near an arm is to a singularity: where two ways to stand become one, and an axis would have to turn endlessly
// fast.
enum class Singular : std::uint8_t { shoulder, elbow, wrist };
inline constexpr std::array<const char*, 3> kSingularNames{"shoulder", "elbow", "wrist"};
struct Nearness {
    Singular which = Singular::wrist;
    double angle = 0; // rad
};

// The nearest.  Shoulder: the wrist's centre over axis 1, as the angle under which its distance from there is seen from
// as far as the arm reaches; elbow: how far the arm is from stretched or folded; wrist: the angle between axes 4 and 6.
// Of other builds, the arc sine of the Jacobian's least singular value, lengths in units of the reach, as "wrist".
Nearness nearness(const Arm& arm, const Posture& posture);

// Which of the ways it stands in; of other builds always the same.
struct Configuration {
    bool behind = false;    // the wrist is behind axis 1, as far as axis 2 looks forward
    bool bent_down = false; // axis 3 stands on the other side of where the arm is straight
    bool flipped = false;   // axis 5 is negative; of parallel axes: on the other side of where the wrist is straight
    friend bool operator==(const Configuration&, const Configuration&) = default;
};
Configuration configuration(const Arm& arm, const Posture& posture);

// All ways to stand with the flange at `flange`: angles in (-pi, pi]; none outside of the arm's reach.  Limits do not
// count.  At a singularity, where an axis is free, it stays at `near`'s.  Of other builds only what iteration finds
// from `near` and from fixed other places to begin at.  Each is right to 1e-6 mm and 1e-8 rad.
// `lack`, if there is none: why.
std::vector<Posture> inverse(const Arm& arm, const geom::Frame& flange, const Posture& near, Lack* lack = nullptr);

// The way to stand that iteration leads to from `from`, in at most so many steps; nothing if it does not get there.
// Angles are not wrapped.
std::optional<Posture> refined(const Arm& arm, const geom::Frame& flange, const Posture& from, int steps);

// The angles of `posture` by whole turns as near to `near` as they come.
Posture unwrapped(const Posture& posture, const Posture& near);

// How far the axes turn from one to the other, at most; rad.
double apart(const Posture& a, const Posture& b);

} // namespace filum::kinematics
