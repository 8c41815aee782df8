// Sharp turns, and the smallest radius of beads.
#pragma once

#include "metrics/planar/beads.hpp"

#include <span>

namespace filum::metrics::planar {

// The measure of the authors of Connected Fermat Spirals (Zhao et al. 2016): at samples evenly along the path, the
// path divides a disc of radius `w` in two; the turn is sharp where the smaller part (the inner side) is less than 0.3
// of the disc. A straight line gives 0.5, a corner of 90 degrees 0.25 at its tip. Only the part of the path through
// the centre counts; samples nearer than `w` to an end of the path are left out.
struct Turns {
    std::size_t samples = 0, sharp = 0;
    // The smallest radius: of the circle through the points of the path half a bead width before, at, and half a bead
    // width after a vertex; below that scale a bead has no shape. Infinite if all is straight.
    double min_radius = 0; // mm
    std::uint32_t layer = 0;
    Vec2 at;

    [[nodiscard]] double share() const {
        return samples > 0 ? static_cast<double>(sharp) / static_cast<double>(samples) : 0;
    }
};

// About `samples` samples, at equal distances along all beads and jogs in layer order; the result does not depend on
// `threads`.
Turns turns(const Beads& beads, double w, std::size_t samples, int threads);

// The path through `centre`, given as points from it forwards and backwards (both begin with it), divides the disc of
// radius `r` around it: the fraction of the smaller part, or -1 if the path ends inside the disc.
double disc_share(std::span<const Vec2> forwards, std::span<const Vec2> backwards, double r);

} // namespace filum::metrics::planar
