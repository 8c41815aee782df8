// Rings made curves that a machine can follow: joined, rounded, with few points, on its grid.
#pragma once

#include "fill/cycle.hpp"
#include "polygon/loops.hpp"
#include "rings/rings.hpp"
#include "toolpath/path.hpp"

#include <cstddef>
#include <vector>

namespace filum::fill {

inline constexpr double kRoundReach = 0.4; // bead widths of path on each side that corners are rounded within

enum class Corners {
    sharp,
    rounded_inside, // but for those of beads along the outline
    rounded,
};

struct Finish {
    double bead_width = 0.4; // mm, where widths differ the narrowest
    double tolerance = 0.01; // mm: what the edges of beads may be off
    bool wind = true;        // stacks of rings as double spirals
    Corners corners = Corners::rounded;
    double reach = 0.16;  // mm of path on each side that they are rounded within
    bool thin_out = true; // leave out the points that are not needed
    Hanging hung{};       // as of join_rings
    double widest = 0;    // mm, of beads; 0: all are alike
};

// The rings of a region as closed curves, one if they can be joined, the longest first; points in whole micrometres,
// no two the same, no spikes.  They may cross themselves where corners were rounded.
std::vector<toolpath::Curve> finished(const rings::Rings& rings, const polygon::Loops& region, const Finish& how);

// Leaves open what tiny rings would lay (a quarter of a bead's square) that no link has room for beside: all but the
// first curve.  Returns that, mm2.
double leave_tiny(std::vector<toolpath::Curve>& curves, double bead_width);

} // namespace filum::fill
