// Bead widths, and the starts of layers.
#pragma once

#include "metrics/planar/beads.hpp"

namespace filum::metrics::planar {

// The distribution of the bead length by width, without connectors.
struct Widths {
    double min = 0, median = 0, mean = 0, max = 0; // mm, by length; 0 without beads
    double bin = 0;                                // mm: 1, 2 or 5 times a power of ten, about an eighth of the median
    double first = 0;                              // mm, lower end of share[0], a multiple of bin
    std::vector<double> share;                     // at most 64 bins; the last one includes all wider beads
};

Widths widths(const Beads& beads);

// Distances between the starts of adjacent layers: for every region, the distance in XY from the start of its first
// bead to that of each region below it. Without `regions`, from every region to the nearest start on the layer below.
struct SeamDistances {
    std::size_t pairs = 0;
    double min = 0, mean = 0, median = 0; // mm
    std::size_t near = 0;                 // pairs nearer than three bead widths
};

SeamDistances seams(const Beads& beads, const std::vector<polygon::Region>& regions, double bead_width);

} // namespace filum::metrics::planar
