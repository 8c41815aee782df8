// Rounds the tight turns of a path.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct PathRounding {
    double spacing = 1;  // mm
    double radius = 2.4; // mm: least radius
    double nearest = 1;  // spacings: least distance of lines that movements may cause; below 1 if beads may be narrower
};

// Rounds turns that are tighter than surface::curve::kKinkRadius to half a spacing, which is the turn to a neighbouring
// line. Joins, births and tips make such turns. Points move by at most half a spacing, as many to one side as to the
// other, so that the same area stays covered. Kinks for which that is not enough stay, and so does all else.
// `s` carries the plan.
void round_kinks(const Surface& s, Plan& plan, double spacing);

// Rounds turns that are tighter than the least radius to it where points need to move by a quarter of a spacing at
// most: ripples, and corners of up to 69 degrees with a radius of 2.4 spacings. It makes no kinks.
void round_bends(const Surface& s, Plan& plan, const PathRounding& o);

} // namespace filum::surfpath::plan
