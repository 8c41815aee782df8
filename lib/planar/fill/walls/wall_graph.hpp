// Thin walls as a plane graph: nodes where walls meet and end, and middle lines between them.
#pragma once

#include "polygon/loops.hpp"
#include "toolpath/path.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace filum::fill::walls {

using geom::Vec2;
using polygon::Loops;

// The middle line of a wall from node a to node b, both included, with the width of the wall at each point.
struct Wall {
    std::uint32_t a = 0, b = 0;
    toolpath::Curve line;
    double length = 0; // mm
};

struct WallGraph {
    std::vector<Vec2> node;
    std::vector<Wall> walls;
};

// The walls of an area that is thin everywhere: its medial axis without the twigs to corners (thin_edges). nullopt if
// some wall is thicker than sqrt(2) `width`, where two beads fit as well as one. Nodes are where walls meet or end. A
// ring without such a place has one node, at the first vertex of the axis. Connected if the area is.
std::optional<WallGraph> wall_graph(const Loops& area, double width);

// The thin walls of any area: the parts thinner than `width` mm, without twigs to corners and short tips (thin_edges).
// A wall has nodes where it becomes thicker (radius width / 2), ends, or meets others.
WallGraph thin_walls(const Loops& area, double width);

// How often each wall must be passed, once or twice, so that one trail passes all walls and nothing else. The total
// length is the shortest in a tree and near the shortest elsewhere: a T-join by pairs of near nodes, which exchange
// partners while that helps. In a tree all walls except those of the longest path are passed twice; in a ring all are
// passed once.
std::vector<int> passes_of_walls(const WallGraph& graph);

} // namespace filum::fill::walls
