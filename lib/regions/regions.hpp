// Contours to connected regions, and how they lie on each other.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

#include <vector>

namespace filum::regions {

struct Options {
    double bead_width = 0.4; // mm; an overlap links two regions if a circle of this diameter fits into it
};

// The connected regions of `layer`, ids from `first_id`, with their overlaps with the regions of the layer below.
std::vector<polygon::Region> regions(const polygon::Layer& layer, const std::vector<polygon::Region>& below,
                                     std::uint32_t first_id, const Options& options, Notes& notes);

} // namespace filum::regions
