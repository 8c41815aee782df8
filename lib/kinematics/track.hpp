// The way of the axes along a whole stroke.
#pragma once

#include "kinematics/chain.hpp"

#include <limits>
#include <span>
#include <string>
#include <vector>

namespace filum::kinematics {

struct Limits {
    double tilt_min = -std::numeric_limits<double>::infinity(), tilt_max = std::numeric_limits<double>::infinity();
    double turn_min = -std::numeric_limits<double>::infinity(), turn_max = std::numeric_limits<double>::infinity();
};

struct Track {
    std::vector<Joints> joints; // one per pose
    double off = 0;             // rad: the most that a tool axis is off its pose's
    std::size_t off_at = 0;     // which
    // The first pose that cannot be reached within the limits, and why; as many as poses if there is none.
    std::size_t stuck = 0;
    std::string why;
};

// Joints for `poses`, in their order, beginning near `before` (of the stroke before).  Of both ways to stand at each
// pose those are taken whose axes travel least over all (dynamic programme; ties: the first way), the turn axis not
// wrapped.  Where the tool is nearly upright the turn is nearly free: it is pulled taut there within `tolerance` rad
// of tool axis, so that it does not spin round, and fades to the true one at eight times the tolerance.
// Positions are always kept.  Should the turn leave its limits, whole turns are added to the whole track; if that
// does not help it is stuck: the stroke must be broken there to unwind.
Track track(const Chain& chain, std::span<const Pose> poses, const Joints& before, double tolerance,
            const Limits& limits = {});

} // namespace filum::kinematics
