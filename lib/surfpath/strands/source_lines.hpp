// The sources of a distance field as curves.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surfpath::strands {

using geom::Vec2;
using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// The segments of the sources joined where their ends meet within 1e-6 mm: closed curves, and open ones that end where
// no segment, or more than one, goes on.  Ordered by the first of their segments.  Segments without length, and
// vertices, are no curves.
std::vector<Line> source_lines(const surface::Sources& sources);

} // namespace filum::surfpath::strands
