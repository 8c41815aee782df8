// What hangs in the air: beads that no bead of the layer below carries.
#pragma once

#include "metrics/planar/beads.hpp"

#include <optional>

namespace filum::metrics::planar {

// A bead is carried where its axis is at most half its width from the edge of a bead of the layer below: half of it or
// more lies on that one, or it overhangs by no more.
struct Air {
    double area = 0;         // mm2 under beads, farther than half a bead from every bead of the layer below
    double length = 0;       // mm of beads that are not carried
    std::size_t layers = 0;  // with any
    double longest = 0;      // mm of the longest stretch of it without an end: the longest bridge, or free end
    std::uint32_t layer = 0; // where that is
    Vec2 at;                 // where it begins
};

// Of all layers but the lowest, which lies on the bed; above a layer without beads everything hangs.  Connectors, which
// are to be removed, neither count nor carry.  `pixel`: mm between the rows that areas are swept by; 0: a quarter of
// the layer's mean bead width.  Same result for any `threads`.
Air measure_air(const Beads& beads, double pixel, int threads);

} // namespace filum::metrics::planar
