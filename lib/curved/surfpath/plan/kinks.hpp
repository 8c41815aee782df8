// Rounds the kinks of a path.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

// Rounds turns of the plan that are tighter than surface::curve::kKinkRadius to half a spacing, which is the turn to a
// neighbouring line. Joins, births and tips make such turns. Points move by at most half a spacing, as many to one side
// as to the other, so that the same area stays covered. Kinks for which that is not enough stay, and so does all else.
// `s` carries the plan.
void round_kinks(const Surface& s, Plan& plan, double spacing);

} // namespace filum::surfpath::plan
