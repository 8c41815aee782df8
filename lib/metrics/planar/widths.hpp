// Bead widths, and where layers begin.
#pragma once

#include "metrics/planar/beads.hpp"

namespace filum::metrics::planar {

// Shares of the bead length by width, connectors left out.
struct Widths {
    double min = 0, median = 0, mean = 0, max = 0; // mm, by length; 0 if there is no bead
    double bin = 0;                                // mm: 1, 2 or 5 times a power of ten, about an eighth of the median
    double first = 0;                              // mm, lower end of share[0], a multiple of bin
    std::vector<double> share;                     // at most 64; the last one holds all that is wider
};

Widths widths(const Beads& beads);

// How far apart neighbouring layers begin: for every region, the distance in XY from its first bead's start to that of
// each region below it.  Without `regions` every region's start is compared with the nearest on the layer below.
struct Seams {
    std::size_t pairs = 0;
    double min = 0, mean = 0, median = 0; // mm
    std::size_t near = 0;                 // pairs nearer than three bead widths
};

Seams seams(const Beads& beads, const std::vector<polygon::Region>& regions, double bead_width);

} // namespace filum::metrics::planar
