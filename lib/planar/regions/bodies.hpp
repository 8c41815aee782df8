// The regions of layers that consist of several bodies, printed by one tool or several.
#pragma once

#include "regions/regions.hpp"

#include <functional>

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
// and the region has the number of the lowest of them; they have the same bead width. Layers that differ in the number
// of layers that they are high stay apart. Regions come by tool, then by height, then as from regions(); ids and
// parents count from 0, and a region within the hole of one with another tool has that one as parent. `gaps`, if not
// null, gets the gaps between bodies that are wider than a hairline, narrower than a bead, and larger than the dot of a
// bead.
std::vector<polygon::Region> body_regions(std::span<const polygon::Layer> bodies, const Options& options, Gaps* gaps,
                                          Notes& notes);

// lay_on() for regions with any tools and heights. `ground` gives what lies on the layer with a number, -1 for the bed.
// A region rests on regions of all tools on the layer where it begins, but a stroke climbs only to one with the same
// tool.
void lay_bodies_on(std::span<polygon::Region> regions, const std::function<Ground(std::int64_t)>& ground,
                   const Options& options, Air& air);

// A note of the gaps; nothing if there are none.
std::optional<Note> note(const Gaps& gaps);

} // namespace filum::regions
