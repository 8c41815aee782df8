// What beads' edges may be off, at first and where curves would cross.  Private to lib/fill.
#pragma once

#include <algorithm>

namespace filum::fill {

// What a bead's edges may be off at first, mm: ten micrometres, and no more than a fortieth of a bead.
inline double tolerance_for(double bead_width) { return std::min(0.01, bead_width / 40); }

// Of that: first the whole, and a sixteenth where the curve would cross itself.
inline constexpr double kShares[] = {1, 1.0 / 16};

} // namespace filum::fill
