// Closed lines made part of the lines beside them.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rows {

using geom::Vec3;
using surface::Surface;
using surface::curve::Line;

// Every closed one of `lines`, the shortest first, becomes a detour of the line beside it with which it runs side by
// side best: that goes over to it, all round it, and back, by two shifts that cross each other and keep to `radius`.
// Those beside which no other line runs for long enough stay closed.  Lines that are taken in are left empty.  `keep`:
// per line, those that stay as they are, but may take in others. Returns where shifts cross.
std::vector<Vec3> splice_loops(const Surface& s, std::vector<Line>& lines, std::vector<char> keep, double spacing,
                               double radius);

} // namespace filum::surfpath::rows
