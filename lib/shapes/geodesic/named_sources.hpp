// Sources by name, as users write them.
#pragma once

#include "base/note.hpp"
#include "geodesic/sources.hpp"

#include <span>
#include <string_view>

namespace filum::geodesic {

// The sources that `words` name, separated by blanks or semicolons:
//   vertex:ID         a vertex by its number in the file, from 0.  `of_file` maps these to vertices of the surface,
//                     kNone for vertices of no triangle; if it is empty, the numbers are those of the surface
//   point:X,Y,Z       the nearest point of the surface; with a note if it is farther than a mean edge
//   boundary[:WHICH]  rims: all (default), outer (of each component the one of the largest extent), or one by number
//   plane:NX,NY,NZ,D  the section of the surface with the plane NX x + NY y + NZ z = D
// Throws Error(usage) for words that name nothing on this surface.
Sources named_sources(const Surface& surface, std::string_view words, Notes& notes,
                      std::span<const std::uint32_t> of_file = {});

} // namespace filum::geodesic
