// A double spiral along the boundary of a surface, one arm inwards and one outwards (Geo-FISO of Kipping et al. 2022,
// joined into one path).
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// One stroke per component, as geo_contour(), except for the spiral: its lanes alternately lead inwards and outwards,
// and meet in a turn at its inner end. So the path begins and ends side by side at the boundary.
Plan geo_fiso(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
