// Curves that cross nothing, from curves that do.
#pragma once

#include "base/note.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill {

// Where a closed curve crosses itself, what lies between is run the other way round, so that the curve comes to the
// crossing and turns back instead; where two curves cross, they become one there.  The line stays where it is, but for
// the crossings, which become points in whole micrometres; so it may cross itself anew close by, and this goes on until
// nothing crosses.  cell: as of crossing_pairs.  Returns how many crossings are left, which a note tells: 0, unless
// rounding moves them about for ever, which no input is known to do.  Curves are closed, with a width per point and no
// features yet.
std::size_t uncross(std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

} // namespace filum::fill
