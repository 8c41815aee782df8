// A region in pieces with walls and beads of their own.  Private to lib/hollow.
#pragma once

#include "polygon/region.hpp"

namespace filum::hollow {

// A piece of what the walls of the whole region leave.
struct Piece {
    polygon::Loops where;    // connected
    std::uint32_t walls = 0; // further rings, along its own outline
    double width = 0;        // mm, of its beads
};

// `rest`, which walls left of the region, along the outlines of its zones; all of it if there are none.  The pieces
// lie side by side: what of a zone is narrower than its beads, because it is cut off there, belongs to what is beside
// it, and the other way round.  Parts no larger than what the edge of a bead flows over are left open, and so is what
// is in no zone and nowhere as wide as half a bead.  Order: the zones', then what is in none, each part in the order of
// polygon::split.
std::vector<Piece> pieces(const polygon::Loops& rest, const polygon::Region& region, double bead_width);

// The narrowest and the widest beads of the region: where it has zones, theirs count as well, mm.
struct Widths {
    double narrowest = 0, widest = 0;
};
Widths widths(const polygon::Region& region, double bead_width);

} // namespace filum::hollow
