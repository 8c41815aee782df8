// Outlines moved sideways: the first step of an offset.
#pragma once

#include "polygon/loops.hpp"

namespace filum::polygon {

// Every loop moved by `delta` mm to its right, to the left if negative: away from the area, if outer loops are
// counter-clockwise. The moved loops may cross themselves and each other; where they wind around a place at least once,
// counter-clockwise, lies the offset of the area.
//
// Where two moved edges part, there is a corner if it is at most `tolerance` mm away from the arc between them, and
// else an arc, off by at most that. So most corners of a curved outline stay one point, and offsets of offsets have no
// more points than the outline.
Loops moved_outlines(const Loops& a, double delta, double tolerance);

} // namespace filum::polygon
