// Thin walls in one pass where that is possible.
#pragma once

#include "fill/walls/wall_graph.hpp"
#include "toolpath/path.hpp"

namespace filum::fill::walls {

struct WallWalk {
    std::vector<toolpath::Curve> curves; // one
    double twice = 0;                    // mm of walls that are passed twice
    Vec2 at;                             // on one of them
};

// One curve along the middle of all walls, that never crosses itself.  A wall that is passed once carries a bead as
// wide as the wall; one that is passed twice carries two lanes of half the wall each (on one line, where lanes would
// cross). Closed if every wall is passed once and every node can be left again, as a ring; else open, from one end of
// the longest path to the other, so that the next layer can come back along it.
//
// At each node the passes are paired in their order around it, so that none crosses another, and circuits that this
// leaves apart are joined by pairing two neighbours anew, which a plane graph always allows (what could not be joined
// would be a curve of its own).  Ties: lower wall first.
WallWalk wall_walk(const WallGraph& graph);

} // namespace filum::fill::walls
