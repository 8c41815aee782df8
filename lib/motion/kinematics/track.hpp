// The joints of a machine with rotary axes along a whole stroke.
#pragma once

#include "kinematics/configurations.hpp"

#include <span>
#include <string>
#include <vector>

namespace filum::kinematics {

// A stretch of a stroke without a lift.
struct TrackStretch {
    std::size_t first = 0;      // index of its first pose, which is also the last one of the stretch before
    std::vector<Joints> joints; // one per pose
};

struct Track {
    std::vector<TrackStretch> pieces;
    double off = 0;             // rad: the largest angle between a tool axis and the axis of its pose
    std::size_t off_at = 0;     // its pose
    double clipped = 0;         // rad: the most by which a tilt was reduced to its limit
    std::size_t clipped_at = 0; // its pose
    std::size_t stuck = 0;      // the first pose that cannot be reached within the limits; the number of poses if none
    std::string why;            // the reason
};

// The joints at `poses`, in their order, from near `before`, the joints at the end of the stroke before. Configurations
// and whole turns are those of configurations(); the turn axis is not wrapped. Positions are always kept.
//
// While the tool is nearly upright, its axis hardly depends on the turn. There the turn changes as little as possible
// while the tool axis stays within `tolerance` rad, so the table does not spin. Up to eight times the tolerance the
// turn fades to its exact value. A tilt that exceeds its limit by the tolerance at most stays at the limit.
//
// On a polar machine the place of the tip determines the turn, and one tilt brings the tool axis as near as it can.
// The tolerance does not hold there.
Track track(const Chain& chain, std::span<const Pose> poses, const Joints& before, double tolerance,
            const Limits& limits = {}, std::span<const Lifting> lifting = {});

} // namespace filum::kinematics
