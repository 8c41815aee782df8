// One path along rows: which turns there are, the order of the rows, and the path itself.
#pragma once

#include "surfpath/turner.hpp"

namespace filum::surfpath {

// The path that passes all rows, from each by a turn to another; where turns do not lead on, along rims and rows.
Plan boustrophedon(const Surface& s, const Rows& rows, const Turning& turning);

} // namespace filum::surfpath
