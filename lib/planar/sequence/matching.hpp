// Maximum matching in a bipartite graph, and the path cover bound from it.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

// next[u] is the node matched to u by an arc of `links`, kNone if none; each node is the next of at most one; as many
// as possible (Hopcroft and Karp 1973). The number of nodes minus that of matches is the least number of paths that
// cover all nodes. Arcs are tried in order, so the first arcs of a node are preferred.
std::vector<Index> maximum_matching(const Arcs& links);

// The number of nodes with a next.
Index matched(const std::vector<Index>& next);

// Lower bound on strokes from links alone: regions minus a maximum matching.
Index path_cover(const Graph& g);

} // namespace filum::sequence
