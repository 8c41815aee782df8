// Lines along a field of directions: field and hybrid.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Whether lines keep to the angle rather than the spacing, where both cannot be had.
bool keeps_angle(const Options& options);

// Lines along what `options.follow` says (field/directions.hpp), the field smoothed until they bend no tighter than the
// least radius, one spacing apart by stripes (field/stripes.hpp); where directions spread, lines are born in twos,
// joined by a hairpin.  Closed lines become spirals, or part of lines beside them (loops.hpp).  Turns "wide" (and
// "usual"): the lines are led into each other as rows are; "hairpin": by tight turns; "none": each is a stroke of its
// own. Facts: rows, cuts, "tightest-bend" 1/mm of the field.  Notes: shifts that cross, where the field bends tighter
// than the least radius though nothing is asked for there, where it leaves what is asked for to keep the radius, and
// where what is to be followed is no number.
// Throws Error(bad_input) if there is nothing to follow.
Plan follow(const surface::Sheet& sheet, const Options& options);

// Rings about all rims, and the sources of components without one, and lines between them where they meet: follow()
// along the lines of equal distance from these.
Plan hybrid(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
