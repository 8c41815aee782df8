// Offset surfaces, on which plies lie.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surface::curve {

struct RaisedSurface {
    Surface surface;    // the same triangles with moved vertices
    double worst = 0;   // mm: greatest error of a vertex's distance
    double folded = 0;  // mm2 of the given surface: triangles that now face the other way
    double blocked = 0; // mm2 of the given surface: triangles with a corner too near to another part
    Vec3 folded_at{}, blocked_at{};
};

// The offset surface at `distance` mm on the side that the surface faces. Every vertex moves to the true distance from
// the whole surface, rather than along its normal, so it also keeps the distance from the other side of a groove.
// Where a groove is narrower than its plies, triangles fold; folds are spread along the level until they vanish, or
// reported. Beyond sharp edges the offset is as round as the size of triangles allows.
RaisedSurface raised(const Surface& s, double distance);

// The same with a distance per vertex, mm, at least 0. Where it changes steeply, the result is nearer to the surface
// than it says.
RaisedSurface raised(const Surface& s, std::span<const double> distance);

// The same surface seen from its back: triangles and half-edges reversed, in the same order.
Surface turned_over(const Surface& s);

} // namespace filum::surface::curve
