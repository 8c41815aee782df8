// Corners of a bead rounded off.  Private to lib/fill.
#pragma once

#include "fill/splices.hpp"

#include <functional>

namespace filum::fill {

struct Reach {
    double mm;              // of path on each side of a corner
    bool at_outline = true; // also where the bead lies along the region's outline; else its corners stay there
};

// The closed line with each point moved to the mean of what lies within the reach of it along the line (less where it
// is narrower than `width`), where it turns there: straight and gently bent stretches stay as they are, and parallel
// corners stay parallel.  What the bead loses in length it gains in width, as far as a machine follows and not past the
// room it has: room(p) is the distance from p to the region's outline, or anything larger than a bead.  May cross
// itself where it came nearer to itself than the reach.
BeadLine rounded(const BeadLine& line, double width, const Reach& reach, const std::function<double(Vec2)>& room);

} // namespace filum::fill
