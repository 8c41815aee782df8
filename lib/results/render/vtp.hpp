// Writes surfaces and toolpaths as VTK's XML polygonal data, for ParaView and other programs.
#pragma once

#include "render/scene.hpp"

#include <string>

namespace filum::render {

// The bytes of the file. Spans become lines. Each point has "normal" (0, 0, 1 if unknown), "width" and "height" in mm
// (0 in a travel). Its "progress" is the mm of bead before it. Each line has "role" (a comment lists the names),
// "stroke", "layer" and "region". Without spans the file holds the triangles of the surface with its fields per vertex;
// vectors stay vectors. Numbers are binary, little-endian, in base 64.
std::string vtp(const Scene& scene);

} // namespace filum::render
