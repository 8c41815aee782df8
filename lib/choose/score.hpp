// What a path is worth, by weights.
#pragma once

#include "metrics/surface/chains.hpp"
#include "surface/sheet.hpp"

#include <string_view>

namespace filum::choose {

// How much each criterion counts, against the sum of all; at least 0.
struct Weights {
    double coverage = 1, load = 1, angle = 0.5, cuts = 0.5, overlap = 0.5;
};

// The weights of `words`, "coverage=1,load=2": those named are changed.
// Throws Error(usage) for unknown names, negative or infinite numbers, and if all are 0.
Weights weights(std::string_view words);

// Of a path on a surface; what lies beside it counts for angle, cuts and length only.
struct Criteria {
    double area = 0;       // mm2, of the surface
    double coverage = 0;   // share of it within half a bead of the path
    double load = 0;       // metrics::surface::pull_adequacy; nan where there is no load case, or no pull
    double paper_load = 0; // metrics::surface::paper_adequacy, for comparison; likewise
    double angle = 0;      // deg: the paper's mean of the top 1 % of angles, at a quarter of the spacing
    double cuts = 0;       // fibres - 1
    double length = 0;     // mm of fibre
    double overlap = 0;    // share of the fibre on the surface that lies on fibre: 1 - covered area / (length * width)
};

// `spacing`: mm, the width of the beads, too; `stable`: to what the coverage is measured.  Throws Error(failure) if
// there is no fibre.
Criteria measure(const metrics::surface::Fibres& fibres, const surface::Sheet& sheet, double spacing, double stable);

// The mean, by weights, of terms from 0 to 1:
//   coverage;  load;  1 - angle / 90 deg;  1 - cuts * cut_length / length;  1 - overlap
// none below 0, and without what is nan.  `cut_length`: mm of fibre that a cut is taken to cost.
double score(const Criteria& c, const Weights& weights, double cut_length);

} // namespace filum::choose
