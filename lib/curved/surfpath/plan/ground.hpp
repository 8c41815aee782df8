// Keeps a path on the surface.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

// Inserts places where a segment of the plan is farther than 0.01 mm from the surface, and splits strokes where the
// surface does not connect two consecutive places, for example across a gap or to a part below.
// Returns the number of splits; adds a note with the longest such distance and its place.
std::size_t keep_to_surface(const Surface& surface, Plan& plan);

} // namespace filum::surfpath::plan
