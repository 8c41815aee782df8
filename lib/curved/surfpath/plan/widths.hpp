// Fits the widths of beads to the room between their lines.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

struct WidthOptions {
    double spacing = 1; // mm: usual width
    double change = 0;  // share by which beads may be wider or narrower
};

// Sets the width of every bead to the room that it has: on each side half of the distance to the next line, or all of
// the distance to the rim, at most half of the greatest width. Sections get places where their width changes.
void fit_widths(const Surface& s, Plan& plan, const WidthOptions& o);

} // namespace filum::surfpath::plan
