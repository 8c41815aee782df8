// Where lines begin on what has no rim.
#pragma once

#include "surface/sheet.hpp"

namespace filum::surfpath {

// Seams for the components of the sheet that have neither a rim nor a source, as sources: lines are laid beside them
// as beside a rim.  Each is a line without a bend:
// - on a surface like a ball, a shortest way between two points that are far from each other: from the first vertex the
//   farthest, and from that the farthest again;
// - on one with handles, a loop that does not divide it: of the shortest through each of some points far from each
//   other the shortest, straightened.
// Each is told with its length, mm, and the place of its middle: NoteCode::surface_opened.
surface::Sources seams(const surface::Sheet& sheet, Notes& notes);

} // namespace filum::surfpath
