// Splices closed lines into neighbouring lines by shifts that cross.
#pragma once

#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::rows {

using geom::Vec3;
using surface::Surface;
using surface::curve::Line;

// Makes every closed line, the shortest first, a detour of another line: of the line beside which it runs best. That
// line shifts over to the loop, follows it all around, and shifts back; the two shifts cross each other and keep
// `radius`. Loops that do not run beside another line for long enough stay closed. Lines that are taken in become
// empty. `keep`: per line, whether it only takes in others. Returns the places where shifts cross.
std::vector<Vec3> splice_loops(const Surface& s, std::vector<Line>& lines, std::vector<char> keep, double spacing,
                               double radius);

} // namespace filum::surfpath::rows
