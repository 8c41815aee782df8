// Seams: joins rims of a mesh that coincide but do not share vertices bit by bit.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

namespace filum::mesh {

// Largest distance of rims that are joined: these fractions of the box's diagonal and of the shortest side at the
// vertex.
inline constexpr double kSeamOfBox = 1e-3, kSeamOfSide = 0.1;

// Vertices of rims this close, as a fraction of the box's diagonal, are one point: half a unit of single precision. A
// program that computes sin(pi) in it puts the copies of a sphere's pole no farther apart.
inline constexpr double kSamePoint = 0x1p-24;

// mm: the width of an ordinary bead. Rims closer than this look like one surface when printed.
inline constexpr double kBead = 0.4;

// Joins rims that run beside each other within the distances above, with their triangles on opposite sides. Of two
// vertices, the one with the higher number moves to the other. Where a vertex lies on the side of a triangle, the
// triangle is split there. Two rims that meet in two points and approximate the same curve with different vertices in
// between are joined, too: they may be as far apart as the arc of a side whose rise is kSeamOfSide of its length. A
// copy of a surface that lies on it is not joined to it. Notes report how many vertices and
// sides were joined, and the length of unjoined rims within kBead of another rim. Does nothing to a closed mesh.
// Vertices keep their numbers; some lose all their triangles.
void join_seams(Mesh& mesh, Notes& notes);

} // namespace filum::mesh
