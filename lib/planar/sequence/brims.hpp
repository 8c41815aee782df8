// Brims and skirts. A brim is printed just before a region inside it, by the same stroke. A skirt is printed before
// everything else of its tool.
#pragma once

#include "sequence/plan.hpp"

namespace filum::sequence {

// Per brim the region whose stroke begins with it: the first of those inside.
// Throws Error(bad_input) if a brim is not another region of the same layer.
std::vector<Pair> brims(std::span<const polygon::Region> regions);

// Each region that must wait for a brim must also wait for its region, so that the brim can be
// moved to just before that. To be called when `g` has all other precedences.
void hold_together(std::span<const Pair> brims, Graph& g);

// Moves each brim to just before its region and links both. Brims have no other links, so each was a stroke of its own
// in the order and in the bound; both decrease by one per brim.
void begin_with(std::span<const Pair> brims, Graph& g, Plan& p);

// The skirts: regions of the class `rim` that are no region's brim.
std::vector<Index> skirts(std::span<const polygon::Region> regions);

// Moves each skirt to just before the first region of its tool, since a skirt fills the nozzle. A skirt lies as low as
// anything else, so it needs to wait for nothing; one that must wait, in a stream of another program, stays.
void put_first(std::span<const Index> skirts, const Graph& g, Plan& p);

} // namespace filum::sequence
