// Fewer points for the same beads.
#pragma once

#include "rings/rings.hpp"
#include "toolpath/path.hpp"

namespace filum::rings {

// The closed bead with few points.  A chord runs, greedily from the first point, as far as the line is within one and a
// half times the `tolerance` of it (mm; no more than an eighth of the width, and on chords longer than three widths
// less, as the gap that they open has no larger area); then its ends are moved along the line to where the turns are
// even, and it is moved aside so that it has as much of the line on its left as on its right.  So an even bend is off
// by the tolerance at the points and by half of it between them; nothing by more than one and a half. Widths are off by
// at most an eighth, by as much below as above, and on no chord by more than `least_void` mm2 in all. Where the width
// changes over a longer way, points divide that: a machine lays each segment with one width, and no more than
// `least_void` aside by that.
toolpath::Curve with_fewer_points(const toolpath::Curve& bead, double tolerance, double least_void);

// The same of all rings, but their turns stay as they come: they are to be joined and rounded yet.
Rings with_fewer_points(const Rings& all, double tolerance, double least_void);

} // namespace filum::rings
