// Closes the holes of a surface, so that distances can be measured across them.
#pragma once

#include "surface/sheet.hpp"

namespace filum::surfpath {

// The surface with a cap over every hole: a fan of triangles around the mean of the rim's vertices. A hole is a rim
// other than the outer one of its component and less than half as long. Triangles and half-edges of `s` keep their
// numbers; the caps' follow.
surface::Surface capped(const surface::Surface& s);

// Completes a seed curve that holes interrupt: where it meets the rim of a hole at exactly two points, the segment on
// the cap between them is added. `closed` is the result of capped(s).
surface::Sources bridged(const surface::Surface& s, const surface::Surface& closed, const surface::Sources& seed);

} // namespace filum::surfpath
