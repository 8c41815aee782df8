// Where curves cross: the certificate of every pattern, and curves that cross nothing from curves that do.
#pragma once

#include "base/note.hpp"
#include "toolpath/grid.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill::join {

using toolpath::crossing_pairs;

// The note NoteCode::curve_crosses_itself with their number and the place of the first, if there are any.
void note_crossings(const std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

// Where a closed curve crosses itself, what lies between is run the other way round, so that the curve comes to the
// crossing and turns back instead; where two curves cross, they become one there.  The line stays where it is, but for
// the crossings, which become points in whole micrometres; so it may cross itself anew close by, and this goes on until
// nothing crosses.  cell: as of crossing_pairs.  Returns how many crossings are left, which a note tells: 0, unless
// rounding moves them about for ever, which no input is known to do.  Curves are closed, with a width per point and no
// features yet.
std::size_t uncross(std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

// Puts the curves on the grid of machines (toolpath/grid.hpp), and sees to it that they cross nothing there: by moving
// points, and where that is not enough by uncross; where that cannot be, as curves are open, a note tells.
void lay_on_grid(std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

} // namespace filum::fill::join
