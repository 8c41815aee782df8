// One path along rows: which turns there are, the order of the rows, and the path itself.
#pragma once

#include "surfpath/rows/turner.hpp"

namespace filum::surfpath::rows {

// The path that passes all rows, from each by a turn to another; where turns do not lead on, along rims and rows.
plan::Plan boustrophedon(const Surface& s, const Rows& rows, const Turning& turning);

} // namespace filum::surfpath::rows
