// The part of the medial axis that lies in walls, necks and tips thinner than a bead. Private to lib/planar/fill.
#pragma once

#include "polygon/medial_axis.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill::walls {

// The medial axis of `area` for beads `width` mm wide. It is exact to half of join::tolerance_for(width), and so is the
// outline it is computed from.
polygon::MedialAxis axis_for(const polygon::Loops& area, double width);

// The medial axis with a node wherever an edge passes `radius` mm.
polygon::MedialAxis split_at(const polygon::MedialAxis& axis, double radius);

// The edges of the axis in walls with a half-thickness below `most` mm, ascending. Twigs to corners and tips are left
// out if they reach at most width / 2 beyond the disc at their foot. Precondition: the axis has a node wherever it
// passes `most` (split_at).
std::vector<std::uint32_t> thin_edges(const polygon::MedialAxis& axis, double width, double most);

} // namespace filum::fill::walls
