// Coverage and crossings, by layer and by region.
#pragma once

#include "metrics/planar/beads.hpp"
#include "metrics/planar/cover.hpp"
#include "metrics/planar/crossings.hpp"

namespace filum::metrics::planar {

// One region, measured by the beads that state it.
struct RegionFigures {
    std::uint32_t region = 0, layer = 0;
    bool known = false;     // has an outline
    std::size_t curves = 0; // number of runs of beads without a stop, except connectors
    std::size_t segments = 0;
    double length = 0;         // mm of extruding segments
    Cover cover;               // its beads with its outline
    std::size_t crossings = 0; // within the region
    Vec2 at;                   // one of its points: the first of its outline, or of its beads
};

// One layer: all its beads with all its outlines.
struct LayerFigures {
    std::uint32_t layer = 0;
    double z = 0; // mm, 0 if unknown
    Cover cover;
    std::size_t crossings = 0;
    std::vector<Vec2> crossing;         // the first few
    std::vector<RegionFigures> regions; // ascending id
};

// `pixel`: mm between the rows along which areas are integrated; 0: a sixteenth of the layer's mean bead width (of 0.4
// mm without beads). Layers ascend by number; those without beads and outlines are absent. The result does not depend
// on `threads`.
std::vector<LayerFigures> measure_layers(const Beads& beads, const std::vector<polygon::Region>& regions, double pixel,
                                         int threads);

// Throws Error(usage) if rows `pixel` mm apart are too many for a layer or would cut the beads too often; 0 never does.
void check_pixel(const Beads& beads, const std::vector<polygon::Region>& regions, double pixel);

// The covered fraction; 1 without an area.
inline double coverage(const Cover& c) { return c.area > 0 ? c.covered / c.area : 1; }

} // namespace filum::metrics::planar
