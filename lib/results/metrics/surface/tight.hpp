// Tight turns of a path, found by its shape, and whether they are declared.
#pragma once

#include "metrics/surface/chains.hpp"

#include <span>

namespace filum::metrics::surface {

struct TightTurns {
    std::size_t count = 0;             // number of tight turns
    double length = 0, undeclared = 0; // mm of them; mm of these outside hairpins
    double least = 0;                  // mm, the least turning radius anywhere; infinite without turns
    // the place of that; the start of the undeclared part of the tightest turn that has one
    Vec3 tightest{}, undeclared_at{};
};

// The parts of the path that turn with a radius below `radius` mm along the surface, as surface::curve::tight_turns
// defines it, independent of roles. `normals`: of the surface, per chain and point, of any length except 0.
TightTurns tight(const Fibres& fibres, std::span<const std::vector<Vec3>> normals, double radius);

} // namespace filum::metrics::surface
