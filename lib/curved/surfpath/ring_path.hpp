// Connects rings to strokes.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Strokes of connected rings: along a crossing each ring leads to the `by`-th next one (lanes::shift()), 1 for a
// spiral and 2 for a double spiral. Branches are joined by exchanges.
Plan ring_path(const surface::Sheet& sheet, const Options& options, int by);

} // namespace filum::surfpath
