// Ways into a bath of gel and out of it, beside the part.
#pragma once

#include "machine/heads.hpp"
#include "toolpath/path.hpp"

#include <vector>

namespace filum::route {

// Adds a travel before the first stroke and one after the last. The first one comes down beside all beads, from `over`
// mm above them, and goes to the first bead at its height; nothing is in the way yet. The last one leads from the last
// bead to such a place, straight; route() finds its way. These places are on the nearest side of the box around all
// beads, as far away as the head is wide in that height, and `over` more.
void add_rim_ways(std::vector<toolpath::Span>& spans, const machine::Heads& heads, double over);

} // namespace filum::route
