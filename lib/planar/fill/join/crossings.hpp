// Finds crossings of curves, the certificate of every pattern, and removes them.
#pragma once

#include "base/note.hpp"
#include "toolpath/grid.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::fill::join {

using toolpath::crossing_pairs;

// Adds a NoteCode::curve_crosses_itself with the number of crossings and the place of the first, if there are any.
void note_crossings(const std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

// Removes crossings. Where a closed curve crosses itself, the stretch between the two passes is reversed. The curve
// then touches the crossing point twice and turns back there. Where two curves cross, they become one.
//
// The line stays where it is, except that crossing points move to whole micrometres. That can create new crossings
// close by, so the search repeats, at most four times per crossing found at first.
//
// `cell`: as in crossing_pairs. Returns the number of crossings that remain, with a note. No known input leaves any.
// Preconditions: curves are closed, with a width per point and without features.
std::size_t uncross(std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

// Puts the curves on the machine grid (toolpath/grid.hpp) without crossings: by moving points, then by uncross. uncross
// needs closed curves with a width per point; for others a note reports the crossings.
void lay_on_grid(std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

} // namespace filum::fill::join
