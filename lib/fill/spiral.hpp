// The default fill: one closed curve per connected region, never crossing itself (docs/algorithms/fill.md).
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill {

struct SpiralOptions {
    double bead_width = 0.4; // mm
    double min_width = 0.1;  // mm: beads narrower than this are reported
    double min_radius = 0;   // mm: the path turns no tighter where there is room for that
};

struct Spiral {
    std::vector<toolpath::Curve> curves; // closed; one, unless rings could not be joined (then a note says so)
    double unplaced = 0;                 // mm2 that no bead reaches: corners and tips
    std::size_t crossings = 0;           // pairs of segments that cross all the same (a note says so)
    Note open{NoteCode::area_left_for_radius, 0, 0}; // of it
};

// Fills one connected region (outer loop first, then holes).  Rings along the lanes of the region (rings/lanes.hpp),
// which share walls of every thickness evenly, are joined to one curve: stacks of rings as double spirals, the rest by
// pairs of links.  Corners and turns are rounded, so that sharp turns are left at the ends of walls, at centres and
// where rings branch.  The result is checked: should it cross itself, it is made again with finer lines, then without
// rounding and spirals.  Notes: beads below min_width (mm of length), rings that could not be joined and
// crossings that no way avoids (counts).
//
// With a min_radius, corners of rings become arcs of that radius, and rings too small for it are left out; a note says
// what area that leaves open, another how many turns are tighter all the same: of links, at the ends of walls, round
// corners of the outline that point inwards.
Spiral spiral(const polygon::Loops& region, const SpiralOptions& options, Notes& notes);

struct ContourOptions {
    double bead_width = 0.4; // mm
    int rings = 0;           // at most this many, from the outline inwards; 0: until the region is full
};

// Contour-parallel fill (the 2019 paper's Cp): closed rings of one connected region (outer loop, then holes), in the
// order of depth, each point with its width: the spiral's before they are joined.  They are checked for crossings, and
// laid finer if there are any.
std::vector<toolpath::Curve> contour(const polygon::Loops& region, const ContourOptions& options);

} // namespace filum::fill
