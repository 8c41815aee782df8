// From rings to strokes.
#pragma once

#include "surfpath/surfpath.hpp"

namespace filum::surfpath {

// Rings joined: by a seam whose lanes go over by `by` (see shift()), and by change-overs elsewhere.
Plan ring_path(const surface::Sheet& sheet, const Options& options, int by);

} // namespace filum::surfpath
