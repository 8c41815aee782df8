// Converts the sources of a distance field to curves.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surfpath::fronts {

using geom::Vec2;
using geom::Vec3;
using surface::Surface;
using surface::curve::Line;
using surface::curve::Place;

// Connects source segments whose ends are within 1e-6 mm of each other, to closed curves and to open ones, which end
// where no segment or several continue. In the order of the first of their segments. Vertices and segments without
// length are left out.
std::vector<Line> source_lines(const surface::Sources& sources);

} // namespace filum::surfpath::fronts
