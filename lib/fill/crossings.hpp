// Where curves cross: the certificate of every pattern.
#pragma once

#include "base/note.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace filum::fill {

// Pairs (i, j), i < j, of segments that cross properly: each goes from one side of the other to the other side.
// Segments are numbered through all curves, a closed curve's last one included.  Ascending.
// cell: mm, about the length of a segment or the space between lines; only the speed depends on it.
std::vector<std::pair<std::uint32_t, std::uint32_t>> crossing_pairs(const std::vector<toolpath::Curve>& curves,
                                                                    double cell);

// The note "curve crosses itself" with their number and the place of the first, if there are any.
void note_crossings(const std::vector<toolpath::Curve>& curves, double cell, Notes& notes);

} // namespace filum::fill
