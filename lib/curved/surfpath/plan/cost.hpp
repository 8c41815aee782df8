// One figure for a plan, to choose between plans of the same surface.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct CostOptions {
    double spacing = 1;      // mm
    double radius = 2.4;     // mm: least radius
    double cut = 50;         // mm of fibre that a cut costs
    double width_change = 0; // share by which beads may be wider or narrower than the spacing
};

// mm2: the area without a bead, the overlap, and the area of the beads that turn tighter than the least radius or are
// cut. So a share of void, of overlap and of tight length count the same. Kinks count twice, as fibre breaks there.
// Kinks must have been rounded (round_path.hpp) already.
double cost(const Surface& surface, Plan plan, const CostOptions& options);

} // namespace filum::surfpath::plan
