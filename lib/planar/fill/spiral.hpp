// The default fill: one closed curve per connected region, never crossing itself (docs/algorithms/fill.md).
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill {

struct SpiralOptions {
    double bead_width = 0.4; // mm
    double min_width = 0.1;  // mm: a note reports beads narrower than this
    double min_radius = 0;   // mm: the minimum radius of the path, where there is room for it
};

struct Spiral {
    std::vector<toolpath::Curve> curves;             // closed; one, unless a note says that rings could not be joined
    double unplaced = 0;                             // mm2 that no bead reaches: corners and tips
    std::size_t crossings = 0;                       // pairs of segments that still cross (with a note)
    Note open{NoteCode::area_left_for_radius, 0, 0}; // the part of `unplaced` lost to the minimum radius
};

// Fills one connected region (outer loop first, then holes) with one closed curve.
//
// Rings follow the lanes of the region (rings/lanes.hpp), which divide walls of every thickness evenly. Stacks of rings
// are joined as double spirals, other rings by pairs of links. Corners and turns are rounded. Sharp turns remain at the
// ends of walls, at centres, and where rings branch. Holes smaller than the least void that counts are closed.
//
// The result is checked. If it crosses itself or is more than one curve, it is made again (join::kAttempts): without
// double spirals, then with finer lines, then with finer lines and without spirals and rounding. The result with the
// fewest crossings is returned. Notes: holes closed, beads below min_width (mm of length), rings that could not be
// joined, and crossings that remain (counts).
//
// With a min_radius, corners of rings become arcs of that radius, and rings too small for it are left out. One note
// gives the area left open, another the number of tighter turns that remain: at links, at the ends of walls, and around
// corners of the outline that point inwards. If the radius prevents one curve without crossings, the region is filled
// without it.
Spiral spiral(const polygon::Loops& region, const SpiralOptions& options, Notes& notes);

struct ContourOptions {
    double bead_width = 0.4; // mm
    int rings = 0;           // at most this many, from the outline inwards; 0: until the region is full
};

// Contour-parallel fill (pattern Cp of the 2019 paper): the closed rings of one connected region (outer loop first,
// then holes), from the outline inwards. They are the rings of `spiral` before they are joined; each point has its
// width. If rings cross, they are made again with finer lines.
std::vector<toolpath::Curve> contour(const polygon::Loops& region, const ContourOptions& options);

} // namespace filum::fill
