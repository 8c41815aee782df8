// Settings for joining rings into one curve, from the best to the safest.
#pragma once

#include <algorithm>

namespace filum::fill::join {

// The first tolerance of bead edges in mm: ten micrometres, and at most a fortieth of a bead.
inline double tolerance_for(double bead_width) { return std::min(0.01, bead_width / 40); }

// Shares of that tolerance: the whole first, a sixteenth if the curve would cross itself.
inline constexpr double kShares[] = {1, 1.0 / 16};

// Settings of one attempt. The next attempt follows if a curve crosses itself or some rings stay apart.
struct Attempt {
    double share; // of tolerance_for()
    bool wind;    // join stacks of rings as double spirals
    bool round;   // round corners
};
inline constexpr Attempt kAttempts[] = {
    {kShares[0], true, true}, {kShares[0], false, true}, {kShares[1], true, true}, {kShares[1], false, false}};

} // namespace filum::fill::join
