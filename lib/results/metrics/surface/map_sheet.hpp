// Maps as surfaces with fields, to be written.
#pragma once

#include "metrics/surface/map.hpp"

#include <cstddef>
#include <string>

namespace filum::metrics::surface {

// The map as a surface with fields: "thickness", "thickness-even", "thickness-nominal" (mm), "fibre-volume" (even over
// nominal, infinite where that is 0), and for every ply "ply-K.thickness" (mm), "ply-K.covered" and "ply-K.twice" (0
// to 1), "ply-K.gap" (mm from the nearest bead's edge, negative under beads), "ply-K.deviation" (degrees) and, for
// plies with an edge, "ply-K.edge" (mm).
filum::surface::Sheet sheet_of(const Map& map, const std::string& name);

// `sheet`; if it would take more than about `most` bytes in a stream, the same fields at fewer points. These are
// `base`, the surface before it was refined, in larger triangles, with values as of surface::curve::transferred().
// Sides are twice as long, or four times, ... If `base` itself is too large, the result has its points.
filum::surface::Sheet within_size(filum::surface::Sheet sheet, const Surface& base, std::size_t most);

} // namespace filum::metrics::surface
