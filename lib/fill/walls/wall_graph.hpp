// A region of thin walls as a plane graph: where walls meet and end, and their middle lines between.
#pragma once

#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace filum::fill::walls {

using geom::Vec2;
using polygon::Loops;

// A wall's middle line from node a to node b, both in it, as wide as the wall.
struct Wall {
    std::uint32_t a = 0, b = 0;
    toolpath::Curve line;
    double length = 0; // mm
};

struct WallGraph {
    std::vector<Vec2> node;
    std::vector<Wall> walls;
};

// The medial axis of `area` without the twigs to its corners (thin_edges), if no wall is thicker than sqrt(2)
// `width`, where two beads would come as near to that as one; else nothing.  Nodes are where walls meet or end; a ring
// without any has one, at the axis' first vertex.  Connected if the area is.
std::optional<WallGraph> wall_graph(const Loops& area, double width);

// The same of the thin parts of any area: where it is thinner than `width`, without twigs to corners and tips that
// reach less than 0.4 width.  A wall ends at a node where it gets thicker (radius width / 2), ends or meets others.
WallGraph thin_walls(const Loops& area, double width);

// How often each wall must be passed at least, once or twice, so that one trail passes all of them and nothing else: in
// sum the shortest in a tree, short in others: a T-join by pairs of near nodes that exchange partners while that helps.
// All walls twice but the longest path, if the graph is a tree; all once, if it is a ring.
std::vector<int> passes_of_walls(const WallGraph& graph);

} // namespace filum::fill::walls
