// Tight turns of a path, found by its shape, and what of them was declared.
#pragma once

#include "metrics/surface/chains.hpp"

#include <span>

namespace filum::metrics::surface {

struct TightTurns {
    std::size_t count = 0;             // stretches
    double length = 0, undeclared = 0; // mm of them; mm of these that lie in no hairpin
    double least = 0;                  // mm, the least radius of turning anywhere; infinite if nothing turns
    Vec3 tightest{}, undeclared_at{}; // where that is; where the tightest stretch that is not all declared is first not
};

// The stretches where the path turns within less than `radius` mm along the surface, as surface::curve::tight_turns has
// it: no role is read for that.  `normals`: of the surface, per chain and point; of any length but 0.
TightTurns tight(const Fibres& fibres, std::span<const std::vector<Vec3>> normals, double radius);

} // namespace filum::metrics::surface
