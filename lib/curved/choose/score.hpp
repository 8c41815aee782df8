// Rates a path by weighted criteria.
#pragma once

#include "metrics/surface/fibres.hpp"
#include "surface/sheet.hpp"

#include <string_view>

namespace filum::choose {

// Weights of the criteria relative to their sum; at least 0.
struct Weights {
    double coverage = 1, load = 1, angle = 0.5, cuts = 0.5, overlap = 0.5;
};

// The default weights changed by `words`, as "coverage=1,load=2".
// Throws Error(usage) for unknown names, for negative or infinite numbers, and if all are 0.
Weights weights(std::string_view words);

// Figures of a path on a surface. Path outside the surface only counts for angle, cuts and length.
struct Criteria {
    double area = 0;       // mm2, of the surface
    double coverage = 0;   // share of it within half a bead of the path
    double load = 0;       // metrics::surface::pull_adequacy; NaN without load case or tension
    double paper_load = 0; // metrics::surface::paper_adequacy, for comparison; NaN as above
    double angle = 0;      // degrees: the paper's mean of the top 1 % of angles, measured at a quarter of the spacing
    double cuts = 0;       // fibres - 1
    double length = 0;     // mm of fibre
    double overlap = 0;    // share of the fibre on the surface that overlaps fibre: 1 - covered area / (length * width)
    double tight = 0;      // mm of fibre that turns tighter than the least radius,
    double kinks = 0;      // and than surface::curve::kKinkRadius
};

// Measures a path. `spacing`: mm, also the width of beads; `least_radius`: mm; `stable`: accuracy of the coverage.
// Throws Error(failure) if the path is empty.
Criteria measure(const metrics::surface::Fibres& fibres, const surface::Sheet& sheet, double spacing,
                 double least_radius, double stable);

// The weighted mean of terms from 0 to 1, without those that are NaN:
//   coverage;  load;  1 - angle / 90 deg;  1 - cuts * cut_length / length;  1 - overlap
// Negative terms count as 0. `cut_length`: mm of fibre that a cut costs.
double score(const Criteria& c, const Weights& weights, double cut_length);

} // namespace filum::choose
