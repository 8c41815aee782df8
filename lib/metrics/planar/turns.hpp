// Sharp turns and the smallest radius of the beads.
#pragma once

#include "metrics/planar/beads.hpp"

#include <span>

namespace filum::metrics::planar {

// The measure of the Connected Fermat Spirals authors (Zhao et al. 2016): at samples spread evenly along the
// path a disc of radius `w` is laid on the path, which cuts it in two; the turn is sharp where the smaller part (the
// inner side) is less than 0.3 of the disc.  A straight line gives 0.5, a corner of 90 degrees 0.25 at its tip. Only
// the stretch of path that passes through the centre counts; samples nearer than that to an end of the path are left
// out.
struct Turns {
    std::size_t samples = 0, sharp = 0;
    // The smallest radius: of the circle through the path's points half a bead width before, at, and after a vertex;
    // below that scale a bead has no shape.  Infinite if all is straight.
    double min_radius = 0; // mm
    std::uint32_t layer = 0;
    Vec2 at;

    [[nodiscard]] double share() const {
        return samples > 0 ? static_cast<double>(sharp) / static_cast<double>(samples) : 0;
    }
};

// About `samples` of them, at fixed distances along all beads and jogs in layer order; same result for any `threads`.
Turns turns(const Beads& beads, double w, std::size_t samples, int threads);

// The path through `centre`, given as the points from it forwards and backwards (both begin with it), cuts the disc of
// radius `r` around it: the smaller part's share of the disc, or -1 if the path ends inside the disc.
double disc_share(std::span<const Vec2> forwards, std::span<const Vec2> backwards, double r);

} // namespace filum::metrics::planar
