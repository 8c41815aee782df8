// Contours to connected regions, and how they lie on each other.
#pragma once

#include "base/note.hpp"
#include "polygon/region.hpp"

#include <vector>

namespace filum::regions {

struct Options {
    double bead_width = 0.4;   // mm; decides which overlaps a stroke can climb
    double tolerance = 0.001;  // mm; how far a removed contour point may lie from the outline
    double least_width = 0.01; // mm; a region into which no circle of this diameter fits is left out, with a note
};

// The connected regions of `layer`, ids from `first_id`, in the order of polygon::split, with their overlaps with
// `below`, the regions of the layer below (pass none if that layer is missing).  Notes carry the layer.
std::vector<polygon::Region> regions(const polygon::Layer& layer, const std::vector<polygon::Region>& below,
                                     std::uint32_t first_id, const Options& options, Notes& notes);

} // namespace filum::regions
