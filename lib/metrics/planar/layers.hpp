// Coverage and crossings, layer by layer and region by region.
#pragma once

#include "metrics/planar/beads.hpp"
#include "metrics/planar/cover.hpp"
#include "metrics/planar/crossings.hpp"

namespace filum::metrics::planar {

// One region, measured by the beads that claim it.
struct RegionFigures {
    std::uint32_t region = 0, layer = 0;
    bool known = false;     // has an outline
    std::size_t curves = 0; // stretches of beads without a stop, connectors not counted
    std::size_t segments = 0;
    double length = 0;         // mm of extruding segments
    Cover cover;               // its beads against its outline
    std::size_t crossings = 0; // within the region
    Vec2 at;                   // a point of it, to find it: first of its outline, or of its beads
};

// One layer, measured by all its beads against all its outlines.
struct LayerFigures {
    std::uint32_t layer = 0;
    double z = 0; // mm, 0 if unknown
    Cover cover;
    std::size_t crossings = 0;
    std::vector<Vec2> crossing;         // the first few
    std::vector<RegionFigures> regions; // ascending id
};

// `pixel`: mm between the rows that areas are swept by; 0: a sixteenth of the layer's mean bead width (of 0.4 mm where
// there is no bead).  Layers ascend by number; those with neither beads nor outlines are absent.  Same result for any
// `threads`.
std::vector<LayerFigures> measure_layers(const Beads& beads, const std::vector<polygon::Region>& regions, double pixel,
                                         int threads);

// Throws Error(usage) if rows `pixel` mm apart are too many for a layer or would cut the beads too often; 0 never does.
void check_pixel(const Beads& beads, const std::vector<polygon::Region>& regions, double pixel);

// The share, 1 where there is no area.
inline double coverage(const Cover& c) { return c.area > 0 ? c.covered / c.area : 1; }

} // namespace filum::metrics::planar
