// Nested rings: the centre lines of beads that follow the outline, from the outside in.
#pragma once

#include "polygon/loops.hpp"

#include <vector>

namespace filum::fill {

using geom::Vec2;
using polygon::Loops;

// Beads lie a little nearer than their width, so that rounding never opens a seam between them; the share of it.
inline constexpr double kRingOverlap = 1.0 / 512;
inline constexpr double kShortestRing = 1.3; // bead widths: shorter rings have no room for a link

struct Rings {
    Loops loops;            // closed, solid on the left, none crossing another
    std::vector<int> level; // per loop: 0 along the outline
};

// The rings inside and including `first`, each `spacing` mm from the one around it, until nothing is left.  Each level
// is the offset of the simplified level before (docs/algorithms/fill.md): the distance between neighbours is exact to
// twice the `tolerance`.  Rings shorter than `min_length` are left out, but not those inside them.
Rings nested_rings(const Loops& first, double spacing, double min_length, double tolerance);

} // namespace filum::fill
