// Machines with two rotary axes: forward and inverse kinematics.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>

namespace filum::kinematics {

using geom::Vec3;

// What each rotary axis carries.
enum class Carrier : std::uint8_t {
    none,        // three axes: the tool is always vertical
    table_table, // `tilt` carries `turn`, which carries the part (trunnion)
    head_table,  // `turn` carries the part, `tilt` the tool
    head_head,   // `turn` carries `tilt`, which carries the tool
    polar,       // as head_table without a y axis: x is the radius, and the turn brings the tip under it
    frame,       // a robot that takes tool frames: no axes are computed, places and tool axes stay as they are
};

// At rest the tilt axis is perpendicular to z and the turn axis is along z. Positive angles are counter-clockwise seen
// against the axis; for an axis that carries the part it is the part that rotates so.
struct Chain {
    Carrier carrier = Carrier::none;
    Vec3 tilt_axis{0, 1, 0};     // unit, horizontal: x for an A axis, y for a B axis, negative for reversed ones
    double turn_sign = 1;        // -1: the C axis counts clockwise
    Vec3 tilt_point, turn_point; // mm: points of the axes that carry the part, at rest
    // mm, for axes that carry the tool: from the tip to the tilt axis, and from there to the turn axis, at rest.
    Vec3 tip_to_tilt, tilt_to_turn;
};

struct Pose {
    Vec3 tip;           // mm, in the part's frame, which is the machine's while all axes are at rest
    Vec3 axis{0, 0, 1}; // unit, in the part's frame: from the tip up the tool
};

struct Joints {
    Vec3 xyz;                  // mm: where the tip would be if all rotary axes were at rest
    double tilt = 0, turn = 0; // rad
};

Pose forward(const Chain& chain, const Joints& joints);

// The tool axis of forward().
Vec3 tool_axis(const Chain& chain, double tilt, double turn);

// Direction in the part's frame of the tool's x axis at rest; perpendicular to the pose's axis.
Vec3 tool_side(const Chain& chain, const Joints& joints);

// The linear axes for rotary axes at `tilt` and `turn` with the tip at `tip` of the part.
Joints place(const Chain& chain, const Vec3& tip, double tilt, double turn);

// Both solutions for a pose, whose turns differ by pi; turn within (-pi, pi], tilt within [-pi, pi]. For vertical
// poses turn is free: 0 and pi. For three axes and robots both are the pose's tip; the axis is ignored. On a polar
// machine the tip's heading determines the turn (0 and pi on the axis), and the tilt is the best for that turn: the
// tangential component of the axis is lost; the second solution has a negative x.
std::array<Joints, 2> inverse(const Chain& chain, const Pose& pose);

// The rotary angles of both solutions.
struct Angles {
    double tilt = 0, turn = 0; // rad
};
std::array<Angles, 2> angles(const Chain& chain, const Pose& pose);

// The joints on the straight way of tip and axes between two poses, at `f` in [0, 1]; a polar machine's turn follows
// the tip.
Joints between(const Chain& chain, const Vec3& from_tip, const Joints& from, const Vec3& to_tip, const Joints& to,
               double f);

// The tilt for which the tool axis is nearest to `axis` while the turn axis is at `turn`.
double best_tilt(const Chain& chain, const Vec3& axis, double turn);

// mm: nearer than this to the turn axis of a polar machine the tip has no heading.
inline constexpr double kOnAxis = 1e-6;

} // namespace filum::kinematics
