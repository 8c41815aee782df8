#include "kinematics/chain.hpp"

#include "geom/angle.hpp"
#include "geom/frame.hpp"

#include <cmath>
#include <numbers>

namespace filum::kinematics {

namespace {

constexpr Vec3 kUp{0, 0, 1};

bool rotary(const Chain& c) { return c.carrier != Carrier::none && c.carrier != Carrier::frame; }

using geom::turned;
using geom::wrapped;

Vec3 turned_by_turn(const Chain& c, const Vec3& v, double turn) { return turned(v, kUp, c.turn_sign * turn); }
Vec3 turned_by_tilt(const Chain& c, const Vec3& v, double tilt) { return turned(v, c.tilt_axis, tilt); }

bool turning_table_only(const Chain& c) { return c.carrier == Carrier::head_table || c.carrier == Carrier::polar; }
bool tilts_tool(const Chain& c) { return turning_table_only(c) || c.carrier == Carrier::head_head; }

// What is along v of the tool at rest, in the frame that the turn axis rotates, at a tilt of the tool or the part.
Vec3 before_turn(const Chain& c, const Vec3& v, double tilt) {
    return turned_by_tilt(c, v, tilts_tool(c) ? tilt : -tilt);
}

// Sign with which the turn acts on such a vector to give it in the part's frame.
double turn_to_part(const Chain& c) { return c.carrier == Carrier::head_head ? 1 : -1; }

// Position of the part's point in the machine's frame.
Vec3 carried(const Chain& c, const Vec3& p, double tilt, double turn) {
    if (c.carrier == Carrier::head_head || !rotary(c)) return p;
    const Vec3 q = c.turn_point + turned_by_turn(c, p - c.turn_point, turn);
    return turning_table_only(c) ? q : c.tilt_point + turned_by_tilt(c, q - c.tilt_point, tilt);
}

Vec3 carried_back(const Chain& c, const Vec3& r, double tilt, double turn) {
    if (c.carrier == Carrier::head_head || !rotary(c)) return r;
    const Vec3 q = turning_table_only(c) ? r : c.tilt_point + turned_by_tilt(c, r - c.tilt_point, -tilt);
    return c.turn_point + turned_by_turn(c, q - c.turn_point, -turn);
}

// Displacement of the tip by the rotary axes of the head.
Vec3 swing(const Chain& c, double tilt, double turn) {
    if (!tilts_tool(c)) return {};
    const Vec3 tilted = turned_by_tilt(c, c.tip_to_tilt, tilt);
    if (turning_table_only(c)) return c.tip_to_tilt - tilted;
    return c.tip_to_tilt + c.tilt_to_turn - turned_by_turn(c, tilted + c.tilt_to_turn, turn);
}

std::array<Angles, 2> polar(const Chain& c, const Pose& pose) {
    const geom::Vec2 d = pose.tip.xy() - c.turn_point.xy();
    const double heading = norm(d) > 0 ? std::atan2(d.y, d.x) : 0;
    std::array<Angles, 2> out;
    for (std::size_t k = 0; k < 2; ++k) {
        out[k].turn = wrapped(c.turn_sign * ((k == 0 ? 0 : std::numbers::pi) - heading));
        out[k].tilt = best_tilt(c, pose.axis, out[k].turn);
    }
    return out;
}

} // namespace

Pose forward(const Chain& c, const Joints& j) {
    if (!rotary(c)) return {j.xyz, kUp};
    return {carried_back(c, j.xyz + swing(c, j.tilt, j.turn), j.tilt, j.turn), tool_axis(c, j.tilt, j.turn)};
}

Vec3 tool_axis(const Chain& c, double tilt, double turn) {
    return rotary(c) ? turned_by_turn(c, before_turn(c, kUp, tilt), turn_to_part(c) * turn) : kUp;
}

Vec3 tool_side(const Chain& c, const Joints& j) {
    constexpr Vec3 x{1, 0, 0};
    if (!rotary(c)) return x;
    return turned_by_turn(c, before_turn(c, x, j.tilt), turn_to_part(c) * j.turn);
}

Joints place(const Chain& c, const Vec3& tip, double tilt, double turn) {
    if (!rotary(c)) return {tip, 0, 0};
    return {carried(c, tip, tilt, turn) - swing(c, tilt, turn), tilt, turn};
}

std::array<Angles, 2> angles(const Chain& c, const Pose& pose) {
    if (!rotary(c)) return {};
    if (c.carrier == Carrier::polar) return polar(c, pose);
    // Tilting moves the vertical axis towards -v, so the horizontal part of the axis must become parallel to v or -v.
    const Vec3 v = cross(kUp, c.tilt_axis);
    const double level = std::hypot(pose.axis.x, pose.axis.y);
    const double heading = level > 0 ? std::atan2(pose.axis.y, pose.axis.x) : std::atan2(-v.y, -v.x);
    std::array<Angles, 2> out;
    for (int k = 0; k < 2; ++k) {
        const double side = k == 0 ? -1 : 1; // along -v first: tools tilt by positive angles there
        const double to = std::atan2(side * v.y, side * v.x);
        out[static_cast<std::size_t>(k)] = {std::atan2(-side * level, pose.axis.z) * (tilts_tool(c) ? 1 : -1),
                                            wrapped(c.turn_sign * -turn_to_part(c) * (to - heading))};
    }
    return out;
}

std::array<Joints, 2> inverse(const Chain& c, const Pose& pose) {
    const auto both = angles(c, pose);
    return {place(c, pose.tip, both[0].tilt, both[0].turn), place(c, pose.tip, both[1].tilt, both[1].turn)};
}

double best_tilt(const Chain& c, const Vec3& axis, double turn) {
    const Vec3 before = turned_by_turn(c, axis, -turn_to_part(c) * turn);
    const Vec3 v = cross(kUp, c.tilt_axis);
    return std::atan2(-dot(before, v), before.z) * (tilts_tool(c) ? 1 : -1);
}

Joints between(const Chain& c, const Vec3& from_tip, const Joints& from, const Vec3& to_tip, const Joints& to,
               double f) {
    const Vec3 tip = from_tip + f * (to_tip - from_tip);
    const double tilt = from.tilt + f * (to.tilt - from.tilt), turn = from.turn + f * (to.turn - from.turn);
    const auto off_axis = [&](const Vec3& p) { return distance(p.xy(), c.turn_point.xy()) >= kOnAxis; };
    if (c.carrier != Carrier::polar || !off_axis(tip)) return place(c, tip, tilt, turn);
    // The configuration is that of the end that is off the axis; whole turns are those of the straight way.
    const bool begins = off_axis(from_tip);
    const auto way = [&](const Vec3& p, double turn_there) {
        return std::lround((turn_there - polar(c, {p, kUp})[0].turn) / std::numbers::pi) % 2 != 0;
    };
    const bool second = begins ? way(from_tip, from.turn) : way(to_tip, to.turn);
    const double under = polar(c, {tip, kUp})[second ? 1 : 0].turn;
    return place(c, tip, tilt, under + 2 * std::numbers::pi * std::round((turn - under) / (2 * std::numbers::pi)));
}

} // namespace filum::kinematics
