// The way of the axes along a whole stroke.
#pragma once

#include "kinematics/configurations.hpp"

#include <span>
#include <string>
#include <vector>

namespace filum::kinematics {

// A stretch of a stroke without a lift.
struct Piece {
    std::size_t first = 0;      // pose; the piece before ends at the same one
    std::vector<Joints> joints; // one per pose
};

struct Track {
    std::vector<Piece> pieces;
    double off = 0;         // rad: the most that a tool axis is off its pose's
    std::size_t off_at = 0; // which
    double clipped = 0;     // rad: the most of it that keeps a tilt within its limits
    std::size_t clipped_at = 0;
    // The first pose that cannot be reached within the limits, and why; as many as poses if there is none.
    std::size_t stuck = 0;
    std::string why;
};

// Joints for `poses`, in their order, beginning near `before` (of the stroke before), along the route of fewest lifts
// and least travel (see route), the turn axis not wrapped.  Where the tool is nearly upright the turn is nearly free:
// it is pulled taut there within `tolerance` rad of tool axis, so that it does not spin round, and fades to the true
// one at eight times the tolerance.  A tilt beyond its limits by no more than the tolerance stays at the limit.
// Positions are always kept.  Of a polar machine the turn is the tip's, and the axis only as near as one tilt allows:
// the tolerance is not kept there.
Track track(const Chain& chain, std::span<const Pose> poses, const Joints& before, double tolerance,
            const Limits& limits = {}, std::span<const Lifting> lifting = {});

} // namespace filum::kinematics
