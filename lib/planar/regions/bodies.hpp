// The regions of layers that consist of several bodies, printed by one tool or several.
#pragma once

#include "regions/regions.hpp"

namespace filum::regions {

// The gaps between bodies that are too narrow for a bead, over all layers.
struct Gaps {
    double volume = 0;       // mm3
    std::size_t layers = 0;  // layers with such a gap
    double worst = 0;        // mm3, largest on one layer
    std::uint32_t layer = 0; // the layer with that one
    geom::Vec2 at;           // a point of it
    void add(const Gaps& further);
};

// The connected regions of one layer, given once for each body. Bodies with the same tool are united where they touch,
// and the region has the number of the lowest of them; they have the same bead width. Regions come by tool, then as
// from regions(); ids and parents count from 0, and a region within the hole of one with another tool has that one as
// parent. `gaps` gets the gaps between bodies that are wider than a hairline, narrower than a bead, and larger than the
// dot of a bead.
std::vector<polygon::Region> body_regions(std::span<const polygon::Layer> bodies, const Options& options, Gaps& gaps,
                                          Notes& notes);

// lay_on() for regions with any tools. A region rests on regions of all tools, but a stroke climbs only to one with the
// same tool.
void lay_bodies_on(std::span<polygon::Region> regions, const Ground& below, const Options& options, Air& air);

// A note of the gaps; nothing if there are none.
std::optional<Note> note(const Gaps& gaps);

} // namespace filum::regions
