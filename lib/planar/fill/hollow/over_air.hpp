// Walls over air count as bridges. Private to lib/planar/fill/hollow.
#pragma once

#include "polygon/region.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill::hollow {

// Sets the feature `bridge` for the stretches of walls that lie over air: their middle is farther than half a bead from
// what carries the region, the region without its bottom surfaces (AreaKind::skin_bottom). Adds points to the curves
// where such stretches begin and end. Stretches shorter than a bead do not count. Nothing changes in a region that is a
// bottom surface throughout: it lies on the bed or on supports, or hangs as a whole.
//
// Precondition: every segment has a feature.
void mark_walls_over_air(const polygon::Region& region, double bead_width, std::vector<toolpath::Curve>& curves);

} // namespace filum::fill::hollow
