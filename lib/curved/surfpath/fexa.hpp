// FExA: rows where parallel planes intersect the surface.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Rows parallel to the plane of the seed curve. The distances of the planes are chosen such that neighbouring rows are
// on average `spacing` apart on the surface.
// Throws Error(bad_input) if there is no seed curve, or if it does not lie in one plane.
Plan fexa(const surface::Sheet& sheet, const Options& options);

// The plane of the seed curve. For a straight seed it is the plane through the seed along the mean surface normal.
// Throws Error(bad_input) if there is none.
surface::Plane plane_of(const Surface& s, const surface::Sources& seed);

} // namespace filum::surfpath
