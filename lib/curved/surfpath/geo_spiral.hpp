// Geo-Spiral: rows along lines of equal distance from a seed point.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// A spiral around the seed point as long as its front meets no rim; the rest is covered by rows of arcs around the
// same point.
// Throws Error(bad_input) unless the sheet's source is one point.
Plan geo_spiral(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
