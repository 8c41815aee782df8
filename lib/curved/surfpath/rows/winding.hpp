// Winds closed rows into open ones: spirals.
#pragma once

#include "surfpath/rows/rows.hpp"

namespace filum::surfpath::rows {

// Connects closed rows at consecutive levels, each beside the next all along, to one row that winds from the first to
// the last: on every lap it shifts evenly from one to the next. The last lap follows the last row alone; it is half a
// lap if the inset is near, on which the spiral then ends. A lap also follows the first row alone, except on the rows
// of least level if not `from_rim`.
// The levels of `rows` must be those along one direction.
void wind(const Surface& s, Rows& rows, double spacing, bool from_rim);

// Sets the levels of closed lines such that wind() recognises their chains, in which each runs beside the next all
// along: levels grow by the spacing within a chain and by much more between chains. Also directs these lines such that
// smaller levels are on their left. Open lines keep their levels. Returns per line the size of its chain; 0 for open
// lines.
std::vector<std::size_t> level_rings(const Surface& s, std::vector<UnclippedLine>& lines, double spacing);

} // namespace filum::surfpath::rows
