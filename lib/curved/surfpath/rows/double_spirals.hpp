// Winds nested closed rows into double spirals.
#pragma once

#include "surfpath/rows/loops.hpp"

namespace filum::surfpath::rows {

// Makes one closed line of closed lines that run side by side: two arms that shift by two lines on every lap, with a
// half turn between them at the first line and one at the last (lanes::wind_loop). `lines` are those of one chain, each
// with the next one on its right; links have at least the gentle radius. It is done where the wedges at the ends of the
// double spiral are smaller than the voids and overlaps of exchanges. Lines over which no ladder leads stay as they
// are. Lines that were taken in become empty. Returns the number of lines that were taken in.
std::size_t wind_double(const Surface& s, std::vector<Line*> lines, const LoopOptions& o);

} // namespace filum::surfpath::rows
