// Parallel lines across a planar area: what `rectilinear` and `zigzag` are made of.
#pragma once

#include "polygon/loops.hpp"

#include <vector>

namespace filum::fill {

// The points turned by `angle` rad about the origin.
polygon::Loops rotated(const polygon::Loops& loops, double angle);
void rotate(std::vector<geom::Vec2>& points, double angle);

// A stretch of a line y = const that lies in the area, mm.
struct Stretch {
    double from = 0, to = 0;
};

// For each y (ascending) the stretches of that line inside `area` (even-odd), from left to right.  An edge belongs to
// the lines lower <= y < upper, so that no vertex is counted twice.
std::vector<std::vector<Stretch>> scan(const polygon::Loops& area, const std::vector<double>& y);

// Where to cut an area into level strips about `height` mm high: ascending y, the first and the last at its bounds.
// Strips are from 1 - give to 1 + give times `height` high where the extent allows it at all (all equally high where
// not).  Within that the cuts fall on the flat parts of the outline, so that strips begin and end where the area does:
// the sum over the outline's flat stretches of length * distance to the nearest cut is least, with a small cost for
// uneven strips.  Resolution: height / 40.  Tie: the strips nearest to `height`, from below.
std::vector<double> cuts(const polygon::Loops& area, double height, double give);

} // namespace filum::fill
