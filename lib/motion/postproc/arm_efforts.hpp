// What a robot's axes went through along a program: nearness to limits and singularities, and slower beads.
#pragma once

#include "base/fact.hpp"
#include "base/note.hpp"
#include "kinematics/arm.hpp"
#include "machine/profile.hpp"

#include <limits>

namespace filum::postproc {

using geom::Vec3;

struct ArmEfforts {
    bool known = false;                                    // the robot has a model
    double room = std::numeric_limits<double>::infinity(); // rad: least distance of an axis from its limit
    std::size_t room_axis = 0;
    Vec3 room_at;
    kinematics::Nearness nearest{kinematics::Singular::wrist,
                                 std::numeric_limits<double>::infinity()}; // nearest approach to a singularity
    Vec3 nearest_at;
    std::uint32_t nearest_layer = 0;
    std::uint64_t uneasy = 0; // strokes that came nearer to one than robot.singular_deg
    double slowed = 0;        // mm of beads printed slower than their feed, so that an axis keeps its speed
    std::uint64_t slow_moves = 0;
    double slowest = 1; // share of its feed that the slowest of these moves keeps
    std::size_t slow_axis = 0;
    Vec3 slowest_at;
    std::uint32_t slowest_layer = 0;
    double spin = 0;        // rad: largest turn of the tool about its own axis
    bool other_way = false; // the program begins in another configuration than robot.start
};

// Adds the notes and facts of these efforts, as of `stage`.  For a robot without a model it adds only the note that
// nothing was checked.
void add_arm_efforts(const machine::Profile& profile, const ArmEfforts& efforts, const std::string& stage, Notes& notes,
                     Facts& facts);

} // namespace filum::postproc
