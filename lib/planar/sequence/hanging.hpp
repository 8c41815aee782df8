// Precedence for regions that begin in the air.
#pragma once

#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// Pairs of a region and a hanging region that must follow it. A region hangs if no region of the next lower layer
// carries it. It follows every lower region of its part, which is connected with it by support. A part without regions
// on the next lower layer counts with the part nearest to it there. So an order that keeps these pairs prints no
// layer before some part of the layer below, and begins on the lowest layer.
// Pairs implied by others or by `g` are left out; of more than kMostBelow regions a hanging one follows the nearest.
inline constexpr std::size_t kMostBelow = 256;
std::vector<Pair> below_hanging(const Graph& g, const std::vector<Outline>& outlines);

} // namespace filum::sequence
