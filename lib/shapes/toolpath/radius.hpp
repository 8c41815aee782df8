// The turning radius of a line.
#pragma once

#include "geom/vec.hpp"

#include <cstddef>
#include <span>

namespace filum::toolpath {

// Radius, mm, of the circle through vertex i of the line and its points `scale` mm before and after it (or the ends of
// an open line, if nearer); 0 where the line reverses, infinite where it is straight. The last point of a closed line
// is connected to its first. Precondition: i is not an end of an open line.
double radius_at(std::span<const geom::Vec2> line, bool closed, std::size_t i, double scale);

} // namespace filum::toolpath
