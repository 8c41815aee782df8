// How the regions of one layer lie on those of the layer below.
#pragma once

#include "polygon/region.hpp"

#include <span>

namespace filum::regions {

// Fills `below` (by ascending id) and `unsupported` of every upper region.
// Candidates come from a sweep over bounding boxes; each connected group of them costs one intersection.
// A link is where a circle of radius w / 4 fits into the common area, or, between walls thinner than that, half the
// smaller of the two inradii: outermost beads run half a bead inside the outlines, so their curves then come within
// about one bead width `w` of each other (docs/algorithms/regions.md#why-it-is-right).
void overlap(std::span<polygon::Region> upper, std::span<const polygon::Region> lower, double w);

} // namespace filum::regions
