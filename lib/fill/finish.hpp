// Rings made curves that a machine can follow: joined, rounded, with few points, on its grid.
#pragma once

#include "fill/join/cycle.hpp"
#include "fill/rounding.hpp"
#include "polygon/loops.hpp"
#include "rings/rings.hpp"
#include "toolpath/path.hpp"

#include <cstddef>
#include <vector>

namespace filum::fill {

struct Finish {
    double bead_width = 0.4; // mm, where widths differ the narrowest
    double tolerance = 0.01; // mm: what the edges of beads may be off
    bool wind = true;        // stacks of rings as double spirals
    Rounded corners = Rounded::everywhere;
    double open = 0;      // mm2 that a rounded right angle leaves; 0: the least void that counts, and all rounded
                          // corners of a curve together no more than rings::kMostOpen of the region
    bool thin_out = true; // leave out the points that are not needed
    join::Hanging hung{}; // as of join_rings
    double widest = 0;    // mm, of beads; 0: all are alike
};

// The rings of a region as closed curves, one if they can be joined, the longest first; points in whole micrometres,
// no two the same, no spikes.  They may cross themselves where corners were rounded.
std::vector<toolpath::Curve> finished(const rings::Rings& rings, const polygon::Loops& region, const Finish& how);

// Leaves open what tiny rings would lay (less than a bead's width squared) that no link has room for beside: all but
// the first curve.  Returns that, mm2.
double leave_tiny(std::vector<toolpath::Curve>& curves, double bead_width);

} // namespace filum::fill
