// Chooses the configuration and the whole turns at each pose of a stroke.
#pragma once

#include "kinematics/chain.hpp"

#include <limits>
#include <span>
#include <vector>

namespace filum::kinematics {

struct Limits {
    double tilt_min = -std::numeric_limits<double>::infinity(), tilt_max = std::numeric_limits<double>::infinity();
    double turn_min = -std::numeric_limits<double>::infinity(), turn_max = std::numeric_limits<double>::infinity();
    double radius_min = -std::numeric_limits<double>::infinity(); // mm, of a polar machine's x
};

// What it costs to lift the tool at a pose in order to change the configuration there.
enum class Lifting : std::uint8_t {
    air,  // nothing: the tool is off the part anyway
    join, // a break where there is no bead
    bead, // a break of a bead
    turn, // a break in a tight turn, where a seam is most visible
};

struct Stop {
    std::size_t pose = 0;
    int configuration = 0; // index of the two solutions of inverse()
    double turn = 0;       // rad, not wrapped
    bool lifted = false;   // the same pose as the stop before in another configuration; the tool was lifted in between
};

struct Configurations {
    std::vector<Stop> stops; // at each pose one, or more with lifts between; as far as `stuck`
    std::size_t stuck = 0;   // first pose that cannot be reached, or as many as poses
};

// Those of fewest breaks; of those with their breaks at the best places (joins, beads, tight turns); of those of
// least travel of both rotary axes (ties: the first configuration, the lowest turn, the earliest lift).  Dynamic
// programme over configurations and whole turns.  A tilt may be out of its limits by `lean` rad.  The tool does not go
// from one to the other where its axis would swing off on the way by more than `lean` and the change of the poses'
// axes, but in the air. `lifting`: per pose, or empty: no lifts, from the air.  Where the first pose is in the air they
// may begin with any whole turn.  First without the turn's limits, whole turns then added to keep them; if none do,
// with them.
Configurations configurations(const Chain& chain, std::span<const Pose> poses, const Joints& before, double lean,
                              const Limits& limits, std::span<const Lifting> lifting);

} // namespace filum::kinematics
