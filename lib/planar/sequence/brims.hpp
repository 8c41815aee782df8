// Brims: each is printed just before a region inside it, by the same stroke.
#pragma once

#include "sequence/plan.hpp"

namespace filum::sequence {

// Per brim the region whose stroke begins with it: the first of those inside.
// Throws Error(bad_input) if a brim is not another region of the same layer.
std::vector<Pair> brims(std::span<const polygon::Region> regions);

// Each region that must wait for a brim must also wait for its region, so that the brim can be moved to just before
// that. Adds to `hits`, pairs of the earlier region and the waiting one.
void hold_together(std::span<const Pair> brims, std::vector<Pair>& hits);

// Moves each brim to just before its region and links both. Brims have no other links, so each was a stroke of its own
// in the order and in the bound; both decrease by one per brim.
void begin_with(std::span<const Pair> brims, Graph& g, Plan& p);

} // namespace filum::sequence
