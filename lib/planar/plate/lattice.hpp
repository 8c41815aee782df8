// Places copies of one outline in rows, without a search. Private to lib/planar/plate.
#pragma once

#include "geom/vec.hpp"

#include <optional>
#include <span>
#include <vector>

namespace filum::plate {

using geom::Vec2;

// Places `count` copies of a convex outline (counter-clockwise, mm) within `size`, so that copies touch but do not
// overlap. Copies stand in straight rows, or in straight columns. Each row is shifted against the row before it so that
// it comes as near as the outlines let it: discs stand like a honeycomb, rectangles like tiles. Of all numbers of
// copies in a row, the one with the smallest half perimeter of the pile is taken. Ties: rows before columns, then fewer
// copies in a row.
//
// Returns the move of each copy, or nothing if they do not fit in this way. `most`: the number of copies that fit.
std::optional<std::vector<Vec2>> lattice(std::span<const Vec2> outline, std::size_t count, Vec2 size,
                                         std::size_t& most);

} // namespace filum::plate
