// Seams: rims of a mesh that lie on each other and do not share their vertices to the bit.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

namespace filum::mesh {

// How far rims may be apart to be joined: this part of the box's diagonal, and of the shortest side at the vertex.
inline constexpr double kSeamOfBox = 1e-3, kSeamOfSide = 0.1;

// mm: the width of an ordinary bead.  Rims within it of each other look like one surface when they are printed.
inline constexpr double kBead = 0.4;

// Joins rims that run beside each other within the distances above, triangles on both sides: a vertex goes to the one
// beside it with the least number; where a vertex lies on the side of a triangle, the triangle is split there.  A copy
// of a surface that lies on it is not joined to it.  Notes say how many vertices and sides, and how long those rims are
// that lie within kBead of another one and are not joined.
// Does nothing to a closed mesh.  Vertices keep their numbers; some have no triangle any more.
void join_seams(Mesh& mesh, Notes& notes);

} // namespace filum::mesh
