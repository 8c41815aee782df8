// Two spirals of lines along the boundary of a surface, one in and one out, side by side (Geo-FISO of Kipping et al.
// 2022, made one path).
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// One stroke per component, as geo_contour() but for the spiral: its lanes lead in and out by turns, and turn back into
// each other at its inner end, so that the path begins and ends side by side at the boundary.
Plan geo_fiso(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
