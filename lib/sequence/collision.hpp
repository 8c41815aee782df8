// Which regions must be printed before which because the head would touch what stands there already.
#pragma once

#include "machine/head.hpp"
#include "sequence/graph.hpp"
#include "sequence/outline.hpp"

namespace filum::sequence {

// Pairs (v, u), v below u: with u printed, the head at v would touch it, so v comes first.  That is so where
// within(u, v, reach(head, z of u - z of v)).  Left out are pairs that others and support (along columns and at the
// foot of a column) imply: per region and other column at most the lowest such u.
std::vector<Pair> collisions(const Graph& g, const Columns& columns, const std::vector<Outline>& outlines,
                             const machine::Head& head);

} // namespace filum::sequence
