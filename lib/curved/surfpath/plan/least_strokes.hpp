// A lower bound on the strokes that cover a surface (docs/algorithms/bounds.md, "How few cuts").
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct StrokeBoundOptions {
    double spacing = 1;     // mm
    double cut_length = 50; // mm of fibre that a cut costs
    bool dead_ends = true;  // whether to count dead ends; not if strokes may leave the surface
};

// Lower bound on the number of strokes of any plan that comes within half a spacing of every place of the components
// marked in `covered` (per component). A plan with fewer strokes has more than cut_length mm of surplus fibre in some
// dead end.
// A stroke lies on one component. A part of the surface must contain an end of a stroke if the way to its farthest
// place and back is longer, by more than cut_length, than its area divided by the spacing. Every stroke has two ends,
// so the bound is the sum over components of 1 or half the number of disjoint such parts. They are searched where rims
// are within two spacings of each other.
std::size_t least_strokes(const Surface& s, std::span<const char> covered, const StrokeBoundOptions& options);

// Adds the fact "cuts-bound": the bound on strokes for the components that the plan covers, less 1.
void report_cuts_bound(const Surface& s, const StrokeBoundOptions& options, Plan& plan);

} // namespace filum::surfpath::plan
