// Names that all of lib/shapes/geodesic uses.
#pragma once

#include "surface/sources.hpp"

namespace filum::geodesic {

using geom::Vec3;
using surface::Segment;
using surface::Sources;
using surface::Surface;

} // namespace filum::geodesic
