// Crossings between beads of a layer.
#pragma once

#include "metrics/planar/cover.hpp"

namespace filum::metrics::planar {

struct Crossings {
    std::size_t whole = 0;         // pairs of beads
    std::vector<std::size_t> slot; // pairs with both beads in one slot
    std::vector<geom::Vec2> place; // of the first few, in the order of the later bead
};

// Pairs of beads whose centre lines cross properly: the ends of each are on both sides of the other, and farther than
// half a micrometre from its line, since a program has whole micrometres. Consecutive beads of the program are not
// pairs. With the layer's `height` (mm, > 0), beads above each other are not pairs either, as the end of a layer above
// its ramp: those that share at most kLevel of the layer's height, if the nozzle of the later one is not lower than the
// top of the earlier one by more. Precondition: `slots` is greater than every bead's slot.
Crossings crossings(std::span<const Bead> beads, std::size_t slots, double height = 0);

} // namespace filum::metrics::planar
