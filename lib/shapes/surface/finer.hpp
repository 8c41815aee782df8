// Refines the triangles of a surface without changing its shape.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

struct FinerSurface {
    Surface surface;
    std::vector<std::uint32_t> parent; // per triangle: the triangle of the given surface that contains it
};

// Halves sides longer than `edge` mm until there are none. Triangles are split at the middles of their long sides,
// consistently with their neighbours. Vertices keep their numbers, and new ones follow; triangles are in the order of
// their parents. Stops before there would be more than `most` triangles.
FinerSurface finer(const Surface& surface, double edge, std::size_t most = 2'000'000);

} // namespace filum::surface
