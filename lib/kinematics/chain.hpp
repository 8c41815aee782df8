// Machines with two rotary axes: where their axes stand for a tool at a place of the part, and back.
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cstdint>

namespace filum::kinematics {

using geom::Vec3;

// What the rotary axes carry.
enum class Carrier : std::uint8_t {
    none,        // three axes: the tool stands upright
    table_table, // the part, turned by `turn`, which `tilt` carries (trunnion)
    head_table,  // `turn` the part, `tilt` the tool
    head_head,   // the tool, tilted by `tilt`, which `turn` carries
    polar,       // as head_table without a y axis: x is the radius, and the turn brings the tip under it
    frame,       // a robot that takes tool frames: no axes are worked out, places and tool axes stay as they are
};

// The tilt axis lies across z, the turn axis along it, at rest.  Positive angles are counter-clockwise seen against the
// axis; of an axis that carries the part, too: it is the part that turns so.
struct Chain {
    Carrier carrier = Carrier::none;
    Vec3 tilt_axis{0, 1, 0};     // unit, level: x for an A axis, y for a B axis, their negatives for reversed ones
    double turn_sign = 1;        // -1: the C axis counts clockwise
    Vec3 tilt_point, turn_point; // mm: of the axes that carry the part, where they pass at rest
    // mm, of axes that carry the tool: from the tip to the tilt axis, and from there to the turn axis, at rest
    Vec3 tip_to_tilt, tilt_to_turn;
};

struct Pose {
    Vec3 tip;           // mm, in the part's frame, which is the machine's while all axes are at rest
    Vec3 axis{0, 0, 1}; // unit, in the part's frame: from the tip up the tool
};

struct Joints {
    Vec3 xyz;                  // mm: where the tip would be were all rotary axes at rest
    double tilt = 0, turn = 0; // rad
};

Pose forward(const Chain& chain, const Joints& joints);

// The axis of forward() alone.
Vec3 tool_axis(const Chain& chain, double tilt, double turn);

// Where what is along x of the tool at rest points to, in the part's frame; across the pose's axis.
Vec3 tool_side(const Chain& chain, const Joints& joints);

// Where the linear axes stand if the rotary ones stand at `tilt` and `turn` and the tip is at `tip` of the part.
Joints place(const Chain& chain, const Vec3& tip, double tilt, double turn);

// Both ways to stand for a pose, turned by pi from each other; turn within (-pi, pi], tilt within [-pi, pi].  Upright
// poses leave the turn free: 0 and pi then.  Of three axes and robots both are the pose's tip; the axis is not kept.
// Of a polar machine the tip's heading gives the turn (0 and pi on the axis), and the tilt is the best of that turn:
// what of the axis lies along the way round is lost.  The second way has a negative x.
std::array<Joints, 2> inverse(const Chain& chain, const Pose& pose);

// The angles of both alone.
struct Angles {
    double tilt = 0, turn = 0; // rad
};
std::array<Angles, 2> angles(const Chain& chain, const Pose& pose);

// On the straight way of tip and axes between two poses, at `f` in [0, 1] of it; a polar machine's turn goes with the
// tip.
Joints between(const Chain& chain, const Vec3& from_tip, const Joints& from, const Vec3& to_tip, const Joints& to,
               double f);

// The tilt that comes nearest to the tool axis `axis` while the turn axis stands at `turn`.
double best_tilt(const Chain& chain, const Vec3& axis, double turn);

// mm: nearer than that to the turn axis of a polar machine, the tip has no heading.
inline constexpr double kOnAxis = 1e-6;

} // namespace filum::kinematics
