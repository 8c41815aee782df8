// What the axes of a robot came near to along a program.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "kinematics/arm.hpp"
#include "machine/profile.hpp"

#include <limits>

namespace filum::postproc {

using geom::Vec3;

struct ArmEfforts {
    bool known = false;                                    // the robot's model is
    double room = std::numeric_limits<double>::infinity(); // rad: the least that an axis was from its limit
    std::size_t room_axis = 0;
    Vec3 room_at;
    kinematics::Nearness nearest{kinematics::Singular::wrist,
                                 std::numeric_limits<double>::infinity()}; // to a singularity ...
    Vec3 nearest_at;
    std::uint32_t nearest_layer = 0;
    std::uint64_t uneasy = 0; // ... and how many strokes came nearer than robot.singular_deg
    double slowed = 0;        // mm of beads laid slower than their feed, so that an axis keeps its speed
    std::uint64_t slow_moves = 0;
    double slowest = 1; // share of its feed that the slowest of them has
    std::size_t slow_axis = 0;
    Vec3 slowest_at;
    std::uint32_t slowest_layer = 0;
    double spin = 0;        // rad: by how much the tool was turned about its own axis, at most
    bool other_way = false; // the program does not begin in the configuration of robot.start
};

// Notes and facts of that, by `stage`; of a robot without a model the note that nothing was checked.
void add_arm_efforts(const machine::Profile& profile, const ArmEfforts& efforts, const std::string& stage, Notes& notes,
                     Facts& facts);

} // namespace filum::postproc
