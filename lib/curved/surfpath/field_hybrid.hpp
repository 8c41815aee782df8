// The algorithms field and hybrid: lines along a field of directions.
#pragma once

#include "surface/sheet.hpp"
#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Whether lines keep to the angle rather than to the spacing, where they cannot keep to both.
bool keeps_angle(const Options& options);

// The directions that lines follow: rings for hybrid, unless others cost less; otherwise those of `options.follow`. If
// nothing is set there: the sheet's field of directions, else its stress, else the angle.
field::DirectionMix directions_followed(const surface::Sheet& sheet, const Options& options);

// Lines along the directions that `options.follow` selects (field/directions.hpp). The directions are smoothed until
// lines bend no tighter than the least radius; stripes (field/stripes.hpp) place the lines one spacing apart. Where
// directions diverge, two new lines begin together, joined by a hairpin. Closed lines become spirals or are joined to
// neighbouring lines (rows/loops.hpp).
// Turns "wide" connect lines by turns of the least radius as rows are, "hairpin" by tight turns, "none" leaves every
// line as a stroke. "usual" takes the cheaper of the first two (plan/cost.hpp); wide ones if options are strict or
// turns lie outside the part. Facts: rows, cuts, births, loops-joined, "tightest-bend" (1/mm, of the field). Notes:
// shifts that cross lines; where the field bends tighter than the least radius although no direction is prescribed
// there; where it departs from the prescribed directions to keep the radius; where a prescribed direction is not a
// finite number. Throws Error(bad_input) if there is no direction to follow.
Plan follow(const surface::Sheet& sheet, const Options& options);

// The options for each source of lines that hybrid tries: lines along rings; if beads may have other widths, also the
// rings as they are, and lines along the directions of the rims, continued into the surface as evenly as possible.
std::vector<Options> hybrid_sources(const Surface& surface, const Options& options);

// Lines along all rims, and along the sources of components without a rim: follow() along one of hybrid_sources(). With
// rings, these are lines of equal distance from the rims, with lines in between where rings meet.
Plan hybrid(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
