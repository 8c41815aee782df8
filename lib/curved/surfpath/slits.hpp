// Seeds lines on surfaces without boundary.
#pragma once

#include "surface/sheet.hpp"

namespace filum::surfpath {

// One source line for every component of the sheet without rim and source: lines start beside it as
// beside a rim. Each is straight on the surface:
// - genus 0: a shortest path between two points that are far apart, the farthest from the first vertex and the farthest
//   from that one;
// - higher genus: the shortest of the non-separating loops through kRoots points that are far from each other,
//   straightened.
// Every line adds the note NoteCode::surface_opened with its length in mm and its middle.
surface::Sources slits(const surface::Sheet& sheet, Notes& notes);

} // namespace filum::surfpath
