// The even cells of patterns.  Private to lib/infill.
#pragma once

#include "infill/infill.hpp"

namespace filum::infill {

// Those that meet the box of `area`, which they reach beyond; none meets another; of no area none.  Concentric lines
// need a rim.
Loops even_cells(const Loops& area, const Lines& lines);

// mm of lines in `area` and of its outline in even cells, by calculation: what loops would be without round corners.
double even_length(const Loops& area, const Lines& lines);

} // namespace filum::infill
