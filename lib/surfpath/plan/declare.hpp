// Turns that are tighter than asked for, found in the finished path and declared.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

// What remains tight, as surface::curve::tight_turns has it.
struct Tight {
    std::size_t count = 0; // stretches
    double length = 0;     // mm of them
    double declared = 0;   // mm of hairpins: these, and what lies beside them
    double least = 0;      // mm, the least radius of the whole path; infinite if nothing of it turns
    Vec3 at;               // where the tightest is
};

// Declares what of the path turns within less than `radius` mm, with `beside` mm before and behind it, as hairpins, and
// nothing else, whatever was declared before.  Measured as it will be laid, `offset` mm along the normals above the
// surface.  The path itself stays as it is.
Tight declare(const Surface& surface, Plan& plan, double radius, double beside, double offset);

} // namespace filum::surfpath::plan
