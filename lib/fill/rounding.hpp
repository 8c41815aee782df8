// Corners of a bead rounded off.  Private to lib/fill.
#pragma once

#include "fill/splices.hpp"

#include <functional>

namespace filum::fill {

// The closed line with each point moved to the mean of what lies within `reach` mm of it along the line (less where it
// is narrower than `width`), where it turns there: straight and gently bent stretches stay as they are, and parallel
// corners stay parallel.  What the bead loses in length it gains in width, as far as a machine follows and not past the
// room it has: room(p) is the distance from p to the region's outline, or anything larger than a bead.  May cross
// itself where it came nearer to itself than `reach`.
BeadLine rounded(const BeadLine& line, double width, double reach, const std::function<double(Vec2)>& room);

// The closed line with its turns a little wider, so that they can be rounded: where it turns back within a bead width
// or so, its two lanes are moved apart just there.
BeadLine with_wide_turns(const BeadLine& line, double width, const std::function<double(Vec2)>& room);

} // namespace filum::fill
