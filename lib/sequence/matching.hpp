// Maximum matching in a bipartite graph: the path cover bound of a set of links.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

// next[u] is the node matched to u by an arc of `links`, kNone if none; each node is next of at most one; as many as
// possible (Hopcroft and Karp 1973).  Nodes less this number is the least count of paths that cover all nodes.
// Arcs are tried in order, so the first arcs of a node are preferred.
std::vector<Index> maximum_matching(const Arcs& links);

// How many nodes have a next.
Index matched(const std::vector<Index>& next);

// Strokes that links alone demand: regions less a maximum matching.
Index path_cover(const Graph& g);

} // namespace filum::sequence
