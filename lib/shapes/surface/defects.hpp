// Repairs a triangle soup before it is connected. Private to lib/shapes/surface.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

inline Note note(NoteCode code, std::size_t count) { return {.code = code, .count = count}; }

// Removes triangles with the same three corners as an earlier one.
void remove_copies(mesh::Mesh& mesh, Notes& notes);

// Removes triangles without area, whose height is below 1e-9 of their longest side. The triangle across that side is
// split at the third corner, so no gap remains.
void remove_flat(mesh::Mesh& mesh, Notes& notes);

// Per half-edge its twin, or kNone.
std::vector<std::uint32_t> join_sides(const mesh::Mesh& mesh, Notes& notes);

// Gives every fan of triangles a vertex of its own; the first of several keeps the vertex of the file. Removes
// vertices without triangles.
void split_fans(mesh::Mesh& mesh, const std::vector<std::uint32_t>& twin, Notes& notes);

} // namespace filum::surface
