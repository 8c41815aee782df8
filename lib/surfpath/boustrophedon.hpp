// One path along rows: which turns there are, the order of the rows, and the path itself.
#pragma once

#include "surfpath/rows.hpp"

namespace filum::surfpath {

struct Turning {
    double spacing = 1;        // mm, between rows
    double least_radius = 2.4; // mm, of turns, where there is room
};

// The path that passes all rows, from each by a turn to another.
Plan boustrophedon(const Surface& s, const Rows& rows, const Turning& turning);

} // namespace filum::surfpath
