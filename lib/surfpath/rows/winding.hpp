// Closed rows made one open row: a spiral.
#pragma once

#include "surfpath/rows/rows.hpp"

namespace filum::surfpath::rows {

// Closed rows that follow each other at neighbouring levels, each beside the next all along, become one row that winds
// from the first to the last: on every lap it goes over from one row to the next, evenly with the way.  A lap follows
// the last row alone, half of one if the inset is near, on which it ends then; and one the first, but for those of the
// least level if not `from_rim`.
// The levels of `rows` are those along one direction.
void wind(const Surface& s, Rows& rows, double spacing, bool from_rim);

// Gives the closed ones of `lines` levels by which wind() finds them, and turns them so that what is less lies to their
// left: in chains of which each runs beside the next, all along, levels grow by the spacing from one to the next, and
// by much more from chain to chain.  Of open ones the level stays.  Returns per line how many its chain has; 0 for open
// ones.
std::vector<std::size_t> level_rings(const Surface& s, std::vector<Raw>& lines, double spacing);

} // namespace filum::surfpath::rows
