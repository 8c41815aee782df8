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

// The cost of lifting the tool at a pose in order to change the configuration there, in ascending order.
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
    // True if the stop before has the same pose in another configuration, and the tool lifts between the two.
    bool lifted = false;
};

struct Configurations {
    std::vector<Stop> stops; // one per pose before `stuck`, or several with lifts between them
    std::size_t stuck = 0;   // the first pose that cannot be reached; the number of poses if all can
};

// Chooses a configuration and whole turns for every pose of a stroke, by dynamic programming. Breaks count first: the
// choice has the fewest, then those at the best places (joins, then beads, then tight turns). The travel of both
// rotary axes counts last. Ties: the first configuration, the lowest turn, the earliest lift.
//
// A tilt may exceed its limits by `lean` rad. Between two poses the tool axis may swing off the poses' axes by at most
// `lean` and the angle between these; in the air it may swing farther. The radius of a polar machine changes its sign
// on the turn axis and in the air only.
//
// `lifting` has an entry per pose. If it is empty, the tool never lifts and comes from the air. A stroke that comes
// from the air may begin with any number of whole turns.
//
// The search ignores the limits of the turn axis at first, and then adds whole turns to keep them. If no number of
// whole turns does, it searches again within the limits.
Configurations configurations(const Chain& chain, std::span<const Pose> poses, const Joints& before, double lean,
                              const Limits& limits, std::span<const Lifting> lifting);

} // namespace filum::kinematics
