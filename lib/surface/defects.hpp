// Repairs of a triangle soup before it is connected; private to lib/surface.
#pragma once

#include "surface/surface.hpp"

namespace filum::surface {

inline Note note(NoteCode code, std::size_t count) { return {.code = code, .count = count}; }

// Leaves out triangles that have the same three corners as an earlier one.
void remove_copies(mesh::Mesh& mesh, Notes& notes);

// Leaves out triangles without area: of height below 1e-9 of their longest side.  The triangle across the longest side
// is split at the third corner, so that no gap remains.
void remove_flat(mesh::Mesh& mesh, Notes& notes);

// Per half-edge the one that it is joined to, or kNone.
std::vector<std::uint32_t> join_sides(const mesh::Mesh& mesh, Notes& notes);

// Gives every fan of triangles its own vertex, and leaves out vertices without a triangle.  Of several fans the first
// keeps the vertex of the file.
void split_fans(mesh::Mesh& mesh, const std::vector<std::uint32_t>& twin, Notes& notes);

} // namespace filum::surface
