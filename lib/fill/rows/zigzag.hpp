// Rows, with rings along the outline or without (docs/algorithms/fill.md); with two of them the 2019 paper's Cs&zigzag
// and Pc&zigzag (Table I, samples 9 and 10).
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill::rows {

struct ZigzagOptions {
    double bead_width = 0.4; // mm
    double angle = 0;        // rad, of the rows from the x axis
    int rings = 0;           // along the outline
    bool linked = true;      // one closed curve of all; else each ring and each part of the core is one
};

// Fills one connected region (outer loop first, then holes): the first lanes of `spiral` as rings, then parallel rows.
// Thin walls cut what the rings leave into a tree of corridors two beads wide (see maze.hpp); the ring along their
// outline is the zigzag: up one side of each corridor, back down the other, from row to row along the outline.  So it
// is closed and can be begun anywhere.  What rings it takes besides (around a wall with two free ends, in a wide place)
// and, if linked, the rings along the outline are joined to it by exchanges.  Where the region is thinner than two
// beads the two lanes share what there is.  Rows are from 0.8 to 1.2 bead widths wide, fitted to the flat parts of the
// outline; every point carries its width.
//
// The result is checked: should it cross itself or, if linked, be more than one curve, it is made again with finer
// lines, then with other rows; the best is returned.  Order: the longest curve first if linked, else rings from outside
// inwards, then cores.  Note: curves that could not be joined (count).  `unplaced`, where given, is set to the area
// that no bead reaches, mm2: corners and tips.
std::vector<toolpath::Curve> zigzag(const polygon::Loops& region, const ZigzagOptions& options, Notes& notes,
                                    double* unplaced = nullptr);

} // namespace filum::fill::rows
