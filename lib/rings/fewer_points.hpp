// Fewer points for the same beads.
#pragma once

#include "toolpath/path.hpp"

namespace filum::rings {

using geom::Vec2;

// Adds a point to a bead, and before it those that divide the way there.  A machine lays each segment with one width:
// so many are needed that none leaves more than `least_void` mm2 open on either side, where each of n leaves a
// triangle, length / (2 n) long and change of width / (4 n) high.
void add_tapered(Vec2 p, double width, double least_void, toolpath::Curve& to);

// The closed bead with few points.  A chord runs, greedily from the first point, as far as the line keeps to a strip
// along it that is twice the `tolerance` wide (mm; and on chords longer than three widths less, as the gap that they
// open has no larger area); then its ends are moved along the line to where the turns are more even, and it is moved
// aside to the middle of that strip.  So the line is off by no more than the tolerance; by no more than an eighth of
// the width before it is moved.  Widths are off by at most an eighth, by as much below as above, and on no chord by
// more than `least_void` mm2 in all. Where the width changes over a longer way, points divide that: a machine lays each
// segment with one width, and no more than `least_void` aside by that.
// Not `even`: turns stay as they come, as of rings that are to be joined and rounded yet.
toolpath::Curve with_fewer_points(const toolpath::Curve& bead, double tolerance, double least_void, bool even);

} // namespace filum::rings
