// Divides a region into pieces that have walls and bead widths of their own. Private to lib/planar/fill/hollow.
#pragma once

#include "polygon/region.hpp"

namespace filum::fill::hollow {

// One piece of the area inside the walls of the region.
struct RegionPiece {
    polygon::Loops where;    // connected
    std::uint32_t walls = 0; // further rings along its own outline
    double width = 0;        // mm, bead width
    double solid = 0;        // mm, bead width of its solid parts
};

// Cuts `rest`, the area inside the walls of the region, along the outlines of its zones. Without zones the pieces are
// the connected parts of `rest`. Pieces lie side by side. A part that is narrower than its bead only because of the cut
// belongs to the piece beside it.
//
// A piece is dropped if its area is at most rings::kLeastVoid bead widths squared. A piece without walls of its own is
// dropped too if it is nowhere as wide as half a bead.
//
// Order: the zones in the order of the region, then the area outside all zones; parts of each in the order of
// polygon::split.
std::vector<RegionPiece> pieces(const polygon::Loops& rest, const polygon::Region& region, double bead_width);

// The narrowest and the widest bead of the region in mm: `bead_width` and the widths of its areas.
struct Widths {
    double narrowest = 0, widest = 0;
};
Widths widths(const polygon::Region& region, double bead_width);

} // namespace filum::fill::hollow
