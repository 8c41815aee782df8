// Beads of a layer that cross each other.
#pragma once

#include "metrics/planar/cover.hpp"

namespace filum::metrics::planar {

struct Crossings {
    std::size_t whole = 0;         // pairs of beads
    std::vector<std::size_t> slot; // pairs with both beads in one slot
    std::vector<geom::Vec2> place; // of the first few, by order of the later bead
};

// Pairs of beads whose centre lines cross properly: each has its ends on either side of the other, by orientations
// whose product is below -1e-12 mm4 (so ends that touch, within about a micrometre, do not cross).  Beads that follow
// each other in the program are no pair.  With the layer's `height` (mm, > 0) neither are those of which one lies over
// the other, as the end of a layer does over its ramp: where they share no more than kLevel of the layer, and the later
// one's nozzle does not run below the top of the earlier one by more.  `slots` > every bead's slot.
Crossings crossings(std::span<const Bead> beads, std::size_t slots, double height = 0);

} // namespace filum::metrics::planar
