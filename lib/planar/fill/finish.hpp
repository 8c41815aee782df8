// Turns rings into curves that a machine can follow: joined, rounded, with few points, on its grid.
#pragma once

#include "fill/join/cycle.hpp"
#include "fill/rings/rings.hpp"
#include "fill/rounding.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <cstddef>
#include <vector>

namespace filum::fill {

struct Finish {
    double bead_width = 0.4; // mm, the narrowest if widths differ
    double tolerance = 0.01; // mm: tolerance of bead edges
    bool wind = true;        // join stacks of rings as double spirals
    Rounded corners = Rounded::everywhere;
    double open = 0;      // mm2 of void at a rounded right angle; 0: the least void that counts, and for all
                          // corners of a curve together at most rings::kMostOpen of the region
    bool thin_out = true; // drop the points that are not needed
    join::Hanging hung{}; // as in join_rings
    double widest = 0;    // mm, widest bead; 0: all beads are bead_width wide
};

// Joins the rings of a region into closed curves, one if possible, the longest first, and rounds their corners. Points
// lie on the grid of whole micrometres, no two consecutive points coincide, and there are no spikes. A curve may cross
// itself where a corner was rounded.
std::vector<toolpath::Curve> finished(const rings::Rings& rings, const polygon::Loops& region, const Finish& how);

// Removes tiny curves: those whose beads cover less than bead_width squared. They are rings that no link could join.
// The first curve always stays. Returns the area in mm2 of the removed beads.
double leave_tiny(std::vector<toolpath::Curve>& curves, double bead_width);

} // namespace filum::fill
