// Rows, with or without rings along the outline (docs/algorithms/fill.md). With two rings they are Cs&zigzag and
// Pc&zigzag of the 2019 paper (Table I, samples 9 and 10).
#pragma once

#include "base/note.hpp"
#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill::rows {

struct ZigzagOptions {
    double bead_width = 0.4; // mm
    double angle = 0;        // rad, of the rows from the x axis
    int rings = 0;           // rings along the outline
    bool linked = true;      // true: one closed curve; false: one for each ring and each part of the core
};

// Fills one connected region (outer loop first, then holes): the first lanes of `spiral` as rings, then parallel rows.
//
// Thin slits divide the area inside the rings into a tree of corridors two beads wide (maze.hpp). The ring along their
// outline is the zigzag. It runs along one side of each corridor and back along the other, from row to row. So it is
// closed and can begin anywhere. Further rings are needed around a slit with two free ends and in wide places.
// Exchanges join these to the zigzag and, if linked, the rings along the outline, too.
//
// Where the region is thinner than two beads, the two lanes divide it. Rows are 0.8 to 1.2 bead widths wide, fitted to
// the flat parts of the outline. Every point has its width.
//
// The result is checked. If it crosses itself or, if linked, is more than one curve, it is made again with finer lines,
// then with other rows; the best is returned. Order: if linked, the longest curve first; else rings from the outside
// inwards, then cores. Notes: the number of curves that could not be joined, and crossings that remain. `unplaced`, if
// given, is set to the area in mm2 that no bead reaches: corners and tips.
std::vector<toolpath::Curve> zigzag(const polygon::Loops& region, const ZigzagOptions& options, Notes& notes,
                                    double* unplaced = nullptr);

} // namespace filum::fill::rows
