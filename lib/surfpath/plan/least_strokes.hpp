// How few strokes can cover a surface (docs/algorithms/bounds.md, "How few cuts").
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct Dearth {
    double spacing = 1;     // mm
    double cut_length = 50; // mm: of fibre that a cut costs
    bool dead_ends = true;  // count them; not where strokes may leave the surface
};

// A bound on the strokes of whoever comes within half a spacing of every place of the components for which `covered`
// (per component) is set: whoever has fewer lays, in some dead end, more than cut_length mm of fibre more than it has
// room for.  A stroke lies on one component; and a part of the surface in which the way to its farthest place and back
// is, by more than cut_length, longer than its area over the spacing must hold an end of a stroke, of which each has
// two.  Parts are looked for where rims face each other within two spacings.  The sum over components of 1, or half of
// as many such parts as are found that have nothing in common.
std::size_t least_strokes(const Surface& s, std::span<const char> covered, const Dearth& options);

// Adds the fact "cuts-bound": the least strokes for the components on which the plan lays something, but one.
void tell_least_cuts(const Surface& s, const Dearth& options, Plan& plan);

} // namespace filum::surfpath::plan
