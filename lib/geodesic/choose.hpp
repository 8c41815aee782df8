// Sources as people name them.
#pragma once

#include "base/note.hpp"
#include "geodesic/sources.hpp"

#include <span>
#include <string_view>

namespace filum::geodesic {

// The sources that `words` name, separated by blanks or semicolons:
//   vertex:ID         a vertex, as numbered in the file from 0; `of_file` tells which one of the surface that is,
//                     kNone if none is; empty: they are numbered alike
//   point:X,Y,Z       the nearest point of the surface; noted if it is farther than a mean edge
//   boundary[:WHICH]  rims: all (default), outer: that of each component that spans the most, or one by its number
//   plane:NX,NY,NZ,D  where the plane NX x + NY y + NZ z = D cuts the surface
// Throws Error(usage) for words that name nothing, or nothing of this surface.
Sources choose(const Surface& surface, std::string_view words, Notes& notes,
               std::span<const std::uint32_t> of_file = {});

} // namespace filum::geodesic
