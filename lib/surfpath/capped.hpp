// A surface with its holes closed, to measure distances past them.
#pragma once

#include "surface/sheet.hpp"

namespace filum::surfpath {

// The surface with a cap over every hole: over rims that are not the outer ones and less than half as long, a fan of
// triangles about the middle of their vertices.  Triangles and half-edges of the surface keep their numbers.
surface::Surface capped(const surface::Surface& s);

// The seed with what is missing of it on caps: where it meets a hole in two places, the line between these.
// `closed` is what capped() made of `s`.
surface::Sources bridged(const surface::Surface& s, const surface::Surface& closed, const surface::Sources& seed);

} // namespace filum::surfpath
