// Connects rows to a path: chooses turns and the order of rows.
#pragma once

#include "surfpath/rows/surface_turn.hpp"

namespace filum::surfpath::rows {

// The path that passes every row and turns from each to the next; where no turn is possible, it leads along rims and
// rows.
plan::Plan boustrophedon(const Surface& s, const Rows& rows, const TurnOptions& turning);

} // namespace filum::surfpath::rows
