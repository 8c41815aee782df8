// Walls that hang over air, partly or wholly. Private to lib/planar/fill/hollow.
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

// Sets the share of the width of walls that lies over air (Curve::over_air): over the bottom surfaces of the region.
// Shares are multiples of 5 %, and at most 5 % off. The share of a segment is that at its middle; a segment longer than
// two beads is cut into pieces of about that length, and pieces of one share stay together. 0 for anything that is no
// wall, and throughout a region that is a bottom surface as a whole.
//
// A bottom surface narrower than a tenth of a bead is none (skins), so smaller shares are 0.
//
// Precondition: as above. To be called before walls become bridges; a bridge that was a wall keeps its share.
void measure_overhangs(const polygon::Region& region, double bead_width, std::vector<toolpath::Curve>& curves);

} // namespace filum::fill::hollow
