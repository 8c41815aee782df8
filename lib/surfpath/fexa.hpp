// FExA: rows where parallel planes cut the surface.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Rows parallel to the plane that the seed curve lies in.  The planes are as far apart as makes neighbouring rows
// `spacing` apart on the surface, in the mean along a row.
// Throws Error(bad_input) if there is no seed curve, or it does not lie in one plane.
Plan fexa(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
