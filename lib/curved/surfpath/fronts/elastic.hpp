// Evens out the distances of lines.
#pragma once

#include "surfpath/fronts/front_lines.hpp"

namespace filum::surfpath::fronts {

// Moves spots along their fronts, except those on source curves, to minimise the sum over all spots of squares of the
// relative excess of the gap, gap / spacing - 1, on both sides and of the slope relative to the straight lines: like an
// elastic sheet around a row that ends in it. Gaps larger than 2.2 spacings do not count. A rim along which a line
// runs is a gap of half a spacing. The order of lines along a front stays the same.
void make_room(std::vector<FrontLine>& lines, const Fronts& fronts, double spacing);

} // namespace filum::surfpath::fronts
