// Strands that make room for each other.
#pragma once

#include "surfpath/strands/strands.hpp"

namespace filum::surfpath::strands {

// Moves spots along their fronts, those on source curves excepted, to where the sum of squares over all spots is least
// of (gap - spacing) / spacing on both sides and of the slope against the straight lines: as an elastic sheet takes up
// a row that ends in it.  Gaps of more than 2.2 spacings are none; rims along which a strand runs are gaps of half a
// spacing.  The order of strands along fronts stays.
void make_room(std::vector<Strand>& strands, const Fronts& fronts, double spacing);

} // namespace filum::surfpath::strands
