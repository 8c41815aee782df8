// The criteria of a path on a curved surface: as the paper prints them, and corrected beside them.
#pragma once

#include "figures/figures.hpp"
#include "metrics/surface/fibres.hpp"
#include "surface/sheet.hpp"

#include <optional>

namespace filum::metrics::surface {

struct Options {
    double spacing = 0;           // mm between neighbouring strands, d; 0: the median bead width
    double step = 0;              // mm between samples, and the finer of the two resamplings; 0: a quarter of d
    double max_curvature = 0.416; // 1/mm: the greatest curvature that the fibre allows
    double min_radius = 0;        // mm: path that turns tighter is reported as tight; 0: 1 / max_curvature
};

struct Measurement {
    figures::Figures figures;                      // in order of importance
    std::optional<filum::surface::Sheet> distance; // if requested
};

// Measures the fibres on the surface of `sheet`, and how closely they follow its load cases. docs/surface-metrics.md
// defines each figure. `distance`: also returns the surface in triangles with sides of at most d / 4 with the field
// "path-distance", mm from the path's centre line, exact at every vertex. The result does not depend on `threads`.
// Throws Error(usage) if d is more than 20 times the bead width or less than a 20th of it, or if the step is longer
// than d or gives more than 20 million samples.
Measurement measure(const Fibres& fibres, const filum::surface::Sheet& sheet, const Options& options, bool distance,
                    int threads);

} // namespace filum::metrics::surface
