// Surfaces and toolpaths for ParaView and its like: VTK's XML polygonal data.
#pragma once

#include "render/scene.hpp"

#include <string>

namespace filum::render {

// The spans as lines, per point "normal" (0, 0, 1 where there is none), "width" and "height" in mm (0 in a travel) and
// "progress", the mm of bead before it; per line "role" (a comment says which is which), "stroke", "layer" and
// "region".  Without spans the surface's triangles with its fields per vertex, vectors as such.  Numbers are binary,
// little-endian, in base 64.
std::string vtp(const Scene& scene);

} // namespace filum::render
