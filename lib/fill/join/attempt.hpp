// Ways to lay one curve, from the best to the safest.
#pragma once

#include <algorithm>

namespace filum::fill::join {

// What beads' edges may be off at first, mm: ten micrometres, and no more than a fortieth of a bead.
inline double tolerance_for(double bead_width) { return std::min(0.01, bead_width / 40); }

// Of that: first the whole, and a sixteenth where the curve would cross itself.
inline constexpr double kShares[] = {1, 1.0 / 16};

// How rings are joined: where a curve would cross itself, or some would stay apart, by the next way.
struct Attempt {
    double share; // of the tolerance
    bool wind;    // stacks of rings as double spirals
    bool round;   // corners
};
inline constexpr Attempt kAttempts[] = {
    {kShares[0], true, true}, {kShares[0], false, true}, {kShares[1], true, true}, {kShares[1], false, false}};

} // namespace filum::fill::join
