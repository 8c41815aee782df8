// Covers thin walls in one pass where possible.
#pragma once

#include "fill/walls/wall_graph.hpp"
#include "toolpath/path.hpp"

namespace filum::fill::walls {

struct WallWalk {
    std::vector<toolpath::Curve> curves; // one, unless circuits could not be joined
    double twice = 0;                    // mm of walls passed twice
    Vec2 at;                             // a point on one of these walls
};

// One curve along the middle of all walls that never crosses itself. A wall that is passed once gets a bead as wide as
// the wall. A wall that is passed twice gets two lanes of half its width, on one line where lanes would cross.
//
// The curve is closed if every wall is passed once and every node can be left again, as in a ring. Else it is open,
// from one end of the longest path to the other, so that the next layer can return along it.
//
// At each node the passes are paired in their order around it, so that none crosses another. Separate circuits are
// joined by pairing two neighbours anew, which a plane graph always allows; if it failed, a circuit would be a curve of
// its own. Ties: the lower wall first.
WallWalk wall_walk(const WallGraph& graph);

} // namespace filum::fill::walls
