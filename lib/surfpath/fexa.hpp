// FExA: rows where parallel planes cut the surface.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Rows parallel to the plane that the seed curve lies in.  The planes are as far apart as makes neighbouring rows
// `spacing` apart on the surface, in the mean along a row.
// Throws Error(bad_input) if there is no seed curve, or it does not lie in one plane.
Plan fexa(const surface::Sheet& sheet, const Options& options);

// The plane through the seed curve; if that is straight, the one that stands upright on the surface along it.
// Throws Error(bad_input) if there is none.
surface::Plane plane_of(const Surface& s, const surface::Sources& seed);

} // namespace filum::surfpath
