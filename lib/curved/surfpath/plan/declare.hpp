// Measures and marks the tight turns of a finished path.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

// The turns of a plan that are tighter than the least radius (surface::curve::tight_turns).
struct TightTurns {
    std::size_t count = 0; // number of such turns
    double length = 0;     // mm of them
    double kinks = 0;      // mm that turn tighter than surface::curve::kKinkRadius
    double fibre = 0;      // mm: the whole path
    double least = 0;      // mm: least radius of the whole path; infinite if it is straight
    Vec3 at;               // place of the tightest turn
};

struct TurnLimits {
    double radius = 0;  // mm: turns below it are tight
    double spacing = 1; // mm between lines
    double beside = 0;  // mm of path before and after each tight turn that is marked with it
    double offset = 0;  // mm above the surface along the normals, where the path will be and radii are measured
};

// Marks exactly the parts of the plan that turn tighter than the radius as hairpins; earlier marks are dropped. Points
// of the path do not change. The mark is for the machine, which may go slower there: it takes nothing from what is
// reported as tight.
TightTurns mark_tight_turns(const Surface& surface, Plan& plan, const TurnLimits& limits);

} // namespace filum::surfpath::plan
