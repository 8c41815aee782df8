// The fill of regions that are not solid all through: walls, skins and sparse infill as one curve
// (docs/algorithms/infill.md).
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"
#include "toolpath/path.hpp"

namespace filum::hollow {

struct Options {
    double bead_width = 0.4; // mm, but for zones
};

// Fills a region that has areas.  Its walls are the outer lanes of the region; what is left of it is cut along its
// zones into pieces, which have further walls, along their own outlines; what these leave is parted into what is sparse
// and what is solid; solid parts get lanes, sparse ones the loops of lib/infill.  All are closed curves one bead apart,
// which are joined to one by exchanges.  Notes: curves that could not be joined.
toolpath::RegionPaths fill(const polygon::Region& region, const Options& options, Notes& notes);

} // namespace filum::hollow
