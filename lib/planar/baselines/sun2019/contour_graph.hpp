// The contour graph of the 2019 paper: contours, their adjacency, and the remaining tree (Figures 3 and 4).
#pragma once

#include "baselines/sun2019/spiral.hpp"

namespace filum::baselines::sun2019 {

using Ring = std::vector<geom::Vec2>; // closed, counter-clockwise

// The equidistant contours, sampled; the outer one first.
std::vector<Ring> contours(const polygon::Loops& region, const SpiralOptions& options);

// Two contours and the vertices where they are nearest.
struct Edge {
    int a = 0, b = 0; // a < b
    double distance = 0;
    std::uint32_t vertex_a = 0, vertex_b = 0;
};

// All pairs of contours with vertices at most `reach` mm apart.  Order: by a, then b.  Tie between vertices: the first.
std::vector<Edge> adjacency(const std::vector<Ring>& rings, double reach);

// A node of the tree; its contour has the same index.
struct Node {
    int parent = -1;           // -1 at the root of a piece
    std::uint32_t start = 0;   // vertex nearest the parent
    std::vector<int> children; // ascending
};

// The edges that the reverse-delete algorithm keeps of `edges`, which are in the order of adjacency(): from the last
// one on, each is removed unless that disconnects its ends. All weights are equal, as elements of the paper's matrix
// are 0 or 1. Cost: edges * (contours + edges), since the connection is searched anew for every edge; `steps` counts
// the edges visited.
std::vector<Edge> reverse_delete(std::size_t contours, std::vector<Edge> edges, std::size_t* steps = nullptr);

// The spanning tree of each piece of the graph, rooted at its first contour.
std::vector<Node> tree(std::size_t contours, const std::vector<Edge>& edges);

} // namespace filum::baselines::sun2019
