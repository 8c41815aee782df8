// The part of the medial axis that lies in walls, necks and tips thinner than a bead.  Private to lib/fill.
#pragma once

#include "polygon/medial_axis.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill {

// The medial axis of `area`, for beads `width` wide: exact to a 64th of that, of the outline too.
polygon::MedialAxis axis_for(const polygon::Loops& area, double width);

// The same with a node wherever a piece passes `radius` mm.
polygon::MedialAxis split_at(const polygon::MedialAxis& axis, double radius);

// The pieces of the axis that a bead follows in thin walls, ascending: those that begin or end where the half-thickness
// is below 0.55 width, without twigs to corners and tips that reach less than 0.4 width beyond the disc at their foot,
// and with what leads on into thicker parts, up to a half-thickness of 0.95 width.
std::vector<std::uint32_t> thin_edges(const polygon::MedialAxis& axis, double width);

} // namespace filum::fill
