// The parts of an area between every other line of a family. Private to lib/planar/infill.
#pragma once

#include "infill/infill.hpp"

#include <optional>

namespace filum::infill {

// The even cells of rows or waves in `area` (simple): what polygon::intersect(area, even_cells(area, lines)) returns,
// up to rounding, the order of loops and points where they touch themselves.
//
// No Boolean operation is needed. The outline is cut where it crosses lines. On each line, what enters and what leaves
// the area alternate, so sorting the crossings tells which ones the line joins. The cost is the number of points of the
// outline, of crossings (n log n), and of points of the lines.
//
// nullopt if rounding puts the crossings of a line in an order that cannot be.
std::optional<Loops> in_even_cells(const Loops& area, const Lines& lines);

} // namespace filum::infill
