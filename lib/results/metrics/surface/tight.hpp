// Tight turns of a path, found by its shape alone.
#pragma once

#include "metrics/surface/fibres.hpp"

#include <span>

namespace filum::metrics::surface {

// The parts of a path that turn tighter than some radius.
struct TightLength {
    std::size_t count = 0; // number of stretches
    double length = 0;     // mm of them
    double least = 0;      // mm, the least radius anywhere, also outside of them; infinite without turns
    Vec3 tightest{};       // the place of that, if there is a stretch
};

// The parts of the path that turn with a radius below `radius` mm along the surface, as surface::curve::tight_turns
// defines it for beads `spacing` mm apart. Roles do not count. `normals`: of the surface, per chain and point, of any
// length except 0.
TightLength tight(const Fibres& fibres, std::span<const std::vector<Vec3>> normals, double radius, double spacing);

} // namespace filum::metrics::surface
