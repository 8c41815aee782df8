// A surface in smaller triangles, of the same shape.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

struct Finer {
    Surface surface;
    std::vector<std::uint32_t> parent; // per triangle: the one of the given surface that it is part of
};

// Halves sides longer than `edge` mm until there is none: every triangle is cut at the middles of its long sides, so
// that neighbours meet.  Vertices keep their numbers, new ones follow; triangles stand in the order of their parents.
// Stops before there would be more than `most` triangles.
Finer finer(const Surface& surface, double edge, std::size_t most = 2'000'000);

} // namespace filum::surface
