// The part of the medial axis that lies in walls, necks and tips thinner than a bead.  Private to lib/fill.
#pragma once

#include "rings/axis.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill {

// The medial axis of `area`, for beads `width` wide: exact to a 64th of that, of the outline too.
rings::Axis axis_for(const polygon::Loops& area, double width);

// The same with a node wherever a piece passes `radius` mm.
rings::Axis split_at(const rings::Axis& axis, double radius);

// The pieces of the axis that a bead follows in thin walls, ascending: those that begin or end where the half-thickness
// is below 0.55 width, without twigs to corners and tips that reach less than 0.4 width beyond the disc at their foot,
// and with what leads on into thicker parts, up to a half-thickness of 0.95 width.
std::vector<std::uint32_t> thin_edges(const rings::Axis& axis, double width);

} // namespace filum::fill
