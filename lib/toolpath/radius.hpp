// How tightly a line turns.
#pragma once

#include "geom/vec.hpp"

#include <cstddef>
#include <span>

namespace filum::toolpath {

// Radius, mm, of the circle through vertex i of the line and its points `scale` mm before and after that along it (of
// an open line its ends, where these are nearer); 0 where it turns straight back, infinite where it runs straight on.
// The last point of a closed line runs on to its first; i is no end of an open one.
double radius_at(std::span<const geom::Vec2> line, bool closed, std::size_t i, double scale);

} // namespace filum::toolpath
