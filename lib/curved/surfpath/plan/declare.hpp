// Declares turns of a finished path that are tighter than the least radius.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

// The turns of a plan that are tighter than the least radius (surface::curve::tight_turns).
struct TightTurns {
    std::size_t count = 0; // number of such turns
    double length = 0;     // mm of them
    double declared = 0;   // mm of hairpins: the turns and the path beside them
    double least = 0;      // mm: least radius of the whole path; infinite if it is straight
    Vec3 at;               // place of the tightest turn
};

// Marks exactly the parts of the plan that turn tighter than `radius` mm as hairpins, with `beside` mm of path before
// and after each; earlier marks are dropped. Radii are measured `offset` mm above the surface along the normals, where
// the path will be. Points of the path do not change.
TightTurns declare(const Surface& surface, Plan& plan, double radius, double beside, double offset);

} // namespace filum::surfpath::plan
