// The part of the medial axis that lies in walls, necks and tips thinner than a bead.  Private to lib/fill.
#pragma once

#include "polygon/medial_axis.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill::walls {

// The medial axis of `area`, for beads `width` wide: exact to a 64th of that, of the outline too.
polygon::MedialAxis axis_for(const polygon::Loops& area, double width);

// The same with a node wherever a piece passes `radius` mm.
polygon::MedialAxis split_at(const polygon::MedialAxis& axis, double radius);

// The pieces of the axis that a bead follows in walls of a half-thickness below `most` mm, ascending; without twigs to
// corners and tips that reach less than 0.4 width beyond the disc at their foot.  An axis that passes `most` has a node
// there (split_at).
std::vector<std::uint32_t> thin_edges(const polygon::MedialAxis& axis, double width, double most);

} // namespace filum::fill::walls
