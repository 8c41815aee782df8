// Represents beads with fewer points.
#pragma once

#include "toolpath/path.hpp"

namespace filum::fill::rings {

using geom::Vec2;

// Appends a point to a bead, and before it points that divide the segment to it. A machine deposits every segment with
// constant width. Of n parts each leaves a triangle of length / (2 n) times change of width / (4 n) on either side; n
// is such that none exceeds `least_void` mm2.
void add_tapered(Vec2 p, double width, double least_void, toolpath::Curve& to);

// The closed bead with few points. From the first point on, each chord is as long as the line stays in a strip along
// it that is twice `tolerance` (mm) wide. On chords longer than three widths the strip is narrower, so that the area
// of the gap does not grow. The ends of chords are then moved along the line to even out the turns, and each chord is
// moved aside to the middle of its strip. So the line moves by at most the tolerance, and by at most an eighth of the
// width before it is moved aside.
// Widths are off by at most an eighth, on average by 0, and on no chord by more than `least_void` mm2. Where the width
// changes over a longer distance, more points divide it (see add_tapered()).
// Not `even`: turns stay as they are, for rings that will be joined and rounded.
toolpath::Curve with_fewer_points(const toolpath::Curve& bead, double tolerance, double least_void, bool even);

} // namespace filum::fill::rings
