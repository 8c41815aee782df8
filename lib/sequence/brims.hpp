// Brims, each laid just before a region that it lies about, by the same stroke.
#pragma once

#include "sequence/plan.hpp"

namespace filum::sequence {

// A brim, and the region whose stroke begins with it: of several that it lies about the first.
// Throws Error(bad_input) where a brim is no other region of the same layer.
std::vector<Pair> brims(std::span<const polygon::Region> regions);

// What must wait for a brim must wait for its region, too: so the brim can move to just before that.  Adds to `hits`,
// pairs of the region that comes first and the one that waits.
void hold_together(std::span<const Pair> brims, std::vector<Pair>& hits);

// Moves each brim to just before its region and links both.  A brim is linked with nothing else, so that each was a
// stroke of its own, in the order as in what bounds it: both have one less for each.
void begin_with(std::span<const Pair> brims, Graph& g, Plan& p);

} // namespace filum::sequence
