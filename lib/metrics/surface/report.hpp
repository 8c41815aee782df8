// The criteria of a path on a curved surface, as printed in the paper and beside them as they should be measured.
#pragma once

#include "metrics/figures/figures.hpp"
#include "metrics/surface/chains.hpp"
#include "surface/sheet.hpp"

#include <optional>

namespace filum::metrics::surface {

struct Options {
    double spacing = 0;           // mm between neighbouring strands, d; 0: the median bead width
    double step = 0;              // mm between samples, and the finer of the two resamplings; 0: a quarter of d
    double max_curvature = 0.416; // 1/mm: what the fibre can be bent to
};

struct Measured {
    metrics::figures::Figures figures;             // in the order in which they are to be read
    std::optional<filum::surface::Sheet> distance; // if asked for
};

// Measures the fibres on the surface of `sheet`, and how well they follow the load cases that it carries.
// docs/surface-metrics.md defines each figure.  `distance`: also gives the surface in triangles with sides of at most
// d / 4 and the field "path-distance", mm from the path's centre line, exact at every vertex.
// Same result for any `threads`.  Throws Error(usage) if d is more than 20 times
// the bead width or less than a 20th of it, and if the step is longer than d or gives more than 20 million samples.
Measured measure(const Fibres& fibres, const filum::surface::Sheet& sheet, const Options& options, bool distance,
                 int threads);

} // namespace filum::metrics::surface
