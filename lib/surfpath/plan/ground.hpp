// No path leaves the surface.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

// Puts places wherever a stretch of the plan would be farther than 0.01 mm from the surface between its ends, and cuts
// strokes where none leads on from a place to the next along the surface: as across a gap, or to what lies below.
// Returns how often; notes them, with the place of the longest such step.
std::size_t keep_to_surface(const Surface& surface, Plan& plan);

} // namespace filum::surfpath::plan
