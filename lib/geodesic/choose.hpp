// Sources as people name them.
#pragma once

#include "base/note.hpp"
#include "geodesic/sources.hpp"

#include <string_view>

namespace filum::geodesic {

// The sources that `words` name, separated by blanks or semicolons:
//   vertex:ID         a vertex, as numbered in the file from 0
//   point:X,Y,Z       the nearest point of the surface; noted if it is farther than a mean edge
//   boundary[:WHICH]  rims: all (default), outer: that of each component that spans the most, or one by its number
//   plane:NX,NY,NZ,D  where the plane NX x + NY y + NZ z = D cuts the surface
// Throws Error(usage) for words that name nothing, or nothing of this surface.
Sources choose(const Surface& surface, std::string_view words, Notes& notes);

} // namespace filum::geodesic
