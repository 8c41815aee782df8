// Finds how the regions of one layer lie on those of the layer below.
#pragma once

#include "polygon/region.hpp"

#include <span>
#include <vector>

namespace filum::regions {

// Fills `below` (by ascending id) of every upper region. Returns the area of each upper region that lies on any lower
// one, mm2. A common area counts as contact only if a circle of diameter `hairline` fits into it: walls side by side
// overlap by rounding errors. Candidates come from a sweep over bounding boxes; each connected group of them costs one
// intersection.
//
// A link needs a circle of radius w / 4 in the common area. Between thinner walls, half the smaller of the two inradii
// is enough. Outermost beads run half a bead inside the outlines. So their curves then come within about one bead width
// `w` of each other (docs/algorithms/regions.md#why-it-is-right).
std::vector<double> overlap(std::span<polygon::Region> upper, std::span<const polygon::Region> lower, double w,
                            double hairline);

} // namespace filum::regions
