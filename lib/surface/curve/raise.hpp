// The surface at a distance from another: what a ply lies on.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surface::curve {

struct Raised {
    Surface surface;    // the same triangles, vertices moved
    double worst = 0;   // mm: the most that a vertex is off the asked distance
    double folded = 0;  // mm2, of the given surface: triangles that face the other way now
    double blocked = 0; // mm2, likewise: triangles with a corner that is nearer than asked to some other part
    Vec3 folded_at{}, blocked_at{};
};

// The surface whose points are `distance` mm from the given one, on the side that it faces: not along old normals only,
// but every vertex on the level of the true distance, so that it keeps off the other side of a groove, too.  Where a
// groove is narrower than its plies, triangles fold; they are spread along the level until they do not, or told.
// Across sharp edges it is as round as triangles are small.
Raised raised(const Surface& s, double distance);

// Likewise, each place as far as `distance` has it, mm per vertex, 0 or more.  What slopes steeply lies nearer than
// that.
Raised raised(const Surface& s, std::span<const double> distance);

// The same surface, seen from its back: triangles and half-edges turned round, in the same order.
Surface turned_over(const Surface& s);

} // namespace filum::surface::curve
