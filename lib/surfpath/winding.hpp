// Closed rows made one open row: a spiral.
#pragma once

#include "surfpath/rows.hpp"

namespace filum::surfpath {

// Closed rows that follow each other at neighbouring levels, each beside the next all along, become one row that winds
// from the first to the last: on every lap it goes over from one row to the next, evenly with the way.  A lap follows
// the last row alone, half of one if the inset is near, on which it ends then; and one the first, but for those of the
// least level if not `from_rim`.
// The levels of `rows` are those along one direction.
void wind(const Surface& s, Rows& rows, double spacing, bool from_rim);

} // namespace filum::surfpath
