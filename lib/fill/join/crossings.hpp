// Where curves cross: the certificate of every pattern, and curves that cross nothing from curves that do.
#pragma once

#include "base/note.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace filum::fill::join {

// Pairs (i, j), i < j, of segments that cross properly: each goes from one side of the other to the other side.
// Segments are numbered through all curves, a closed curve's last one included.  Ascending.
// cell: mm, about the length of a segment or the space between lines; only the speed depends on it.
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const std::vector<toolpath::Curve>& curves,
                                                                    double cell);

// The note "curve crosses itself" with their number and the place of the first, if there are any.
void note_crossings(const std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

// Where a closed curve crosses itself, what lies between is run the other way round, so that the curve comes to the
// crossing and turns back instead; where two curves cross, they become one there.  The line stays where it is, but for
// the crossings, which become points in whole micrometres; so it may cross itself anew close by, and this goes on until
// nothing crosses.  cell: as of crossing_pairs.  Returns how many crossings are left, which a note tells: 0, unless
// rounding moves them about for ever, which no input is known to do.  Curves are closed, with a width per point and no
// features yet.
std::size_t uncross(std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

} // namespace filum::fill::join
