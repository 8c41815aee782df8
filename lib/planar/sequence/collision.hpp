// Precedence from collisions: regions that must be printed before others because the head would touch these.
#pragma once

#include "machine/head.hpp"
#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// Pairs (v, u) with v below u: if u is printed, the head over v touches it, so v must come first. That is the case if
// within(u, v, reach(head, z of u - z of v)). Pairs implied by others and by support (along columns and at the foot of
// a column) are left out: per region and other column only the lowest such u is given.
std::vector<Pair> collisions(const Graph& g, const Columns& columns, const std::vector<Outline>& outlines,
                             const machine::Head& head);

} // namespace filum::sequence
