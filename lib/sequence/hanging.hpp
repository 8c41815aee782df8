// What must be printed before a region that begins in the air.
#pragma once

#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// Pairs of a region and a region that hangs and must follow it.  A region hangs if no region of the next lower layer
// carries it.  It follows every lower region of its part: the regions that are connected with it by support.  A part
// that has no lower region itself counts with the part that is nearest to it on the next lower layer.  So an order
// that keeps these pairs prints no layer before something of the layer below it, and begins on the lowest layer.
// Pairs that others or `g` imply are left out; of more than kMostBelow regions a hanging one follows the nearest.
inline constexpr std::size_t kMostBelow = 256;
std::vector<Pair> below_hanging(const Graph& g, const std::vector<Outline>& outlines);

} // namespace filum::sequence
