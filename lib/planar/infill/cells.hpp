// The even cells of the patterns (infill.hpp). Private to lib/planar/infill.
#pragma once

#include "infill/infill.hpp"

namespace filum::infill {

// The even cells that meet the bounding box of `area`. They reach beyond that box, and no two touch. An empty area has
// none. Precondition: concentric lines have a rim.
Loops even_cells(const Loops& area, const Lines& lines);

// The parts of `area` (simple) in even cells: by index (strips.hpp), bands along a rim by intersection.
Loops cells_in(const Loops& area, const Lines& lines);

// The length in mm of the lines in `area` and of its outline inside even cells, by calculation. It is the length of the
// loops if no corner were rounded and no narrow cell left out.
double even_length(const Loops& area, const Lines& lines);

} // namespace filum::infill
