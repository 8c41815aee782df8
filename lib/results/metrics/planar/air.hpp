// Overhangs and bridges: beads without support by a bead of the layer below.
#pragma once

#include "metrics/planar/beads.hpp"

#include <optional>

namespace filum::metrics::planar {

// A bead is supported where its axis is at most half its width from the edge of a bead of the layer below: at least
// half of its width lies on that bead, or it overhangs by at most as much.
struct Air {
    double area = 0;         // mm2 under beads, farther than half a bead width from every bead of the layer below
    double length = 0;       // mm of beads without support
    std::size_t layers = 0;  // number of layers with any
    double longest = 0;      // mm: the longest connected length of it: the longest bridge, or free end
    std::uint32_t layer = 0; // the layer of that
    Vec2 at;                 // its start
};

// For all layers except the lowest, which lies on the bed; above a layer without beads all beads are unsupported.
// Connectors are removed later, so they do not count and do not support. `pixel`: mm between the rows along which
// areas are integrated; 0: a quarter of the layer's mean bead width. The result does not depend on `threads`.
Air measure_air(const Beads& beads, double pixel, int threads);

} // namespace filum::metrics::planar
