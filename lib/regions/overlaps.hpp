// How the regions of one layer lie on those of the layer below.
#pragma once

#include "polygon/region.hpp"

#include <span>
#include <vector>

namespace filum::regions {

// Fills `below` (by ascending id) of every upper region, and returns how much of each lies on any lower one, mm2.
// A common area into which no circle of diameter `hairline` fits is no contact: walls that stand side by side touch by
// what rounding leaves.  Candidates come from a sweep over bounding boxes; each connected group of them costs one
// intersection. A link is where a circle of radius w / 4 fits into the common area, or, between walls thinner than
// that, half the smaller of the two inradii: outermost beads run half a bead inside the outlines, so their curves then
// come within about one bead width `w` of each other (docs/algorithms/regions.md#why-it-is-right).
std::vector<double> overlap(std::span<polygon::Region> upper, std::span<const polygon::Region> lower, double w,
                            double hairline);

} // namespace filum::regions
