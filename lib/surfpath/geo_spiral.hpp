// Geo-Spiral: rows along lines of equal distance from a seed point.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// A spiral about the seed point until its front meets a rim, then what is left in rows of arcs about the same point,
// until all is covered.
// Throws Error(bad_input) if the sheet's source is no single point.
Plan geo_spiral(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
