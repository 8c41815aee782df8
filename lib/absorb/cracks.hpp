// Cracks: slits between two lanes, long and narrow, that no nose can fill.
#pragma once

#include "absorb/chain.hpp"

#include <span>

namespace filum::absorb {

// Widens the beads on both sides of slits narrower than a sixth of `width`, each by half of the slit on either hand
// (positions stay, widths alone change).  Slits are looked for beside the long ones of `segments`, one place per bead
// width; a bead grows by the least slit found along it.  Places out of the tile do not count.
void close_cracks(Tile& tile, Chain& chain, const Near& near, std::span<const std::uint32_t> segments, double width);

} // namespace filum::absorb
