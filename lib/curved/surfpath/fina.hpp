// FInA: rows along lines of equal distance from a seed curve.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Rows along lines of equal geodesic distance from the seed curve, `spacing` apart.
// Throws Error(bad_input) if the sheet has no seed curve.
Plan fina(const surface::Sheet& sheet, const Options& options);

} // namespace filum::surfpath
