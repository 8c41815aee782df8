// A lower bound for strokes from columns that stand in each other's way.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

// Take one stretch of links from each of k columns such that for every two of them, a[i..i'] and b[j..j'], the foot of
// each must precede the head of the other.  Of two unbroken ones, one would be printed first as a whole, its head
// before the other's foot; so at most one is unbroken, and k - 1 links at least are not used.  For such windows without
// common links this adds up: strokes >= regions - matching(links in no window) - sum over windows (links - (k - 1)).
// Windows are packed from below: the pair that ends lowest, then every column that raises the yield per link.
// `collisions` as from collisions().
Index window_bound(const Graph& g, const Columns& columns, const std::vector<Pair>& collisions);

} // namespace filum::sequence
