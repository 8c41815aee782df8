// What is wrong with a surface along its edges: triangles that face the other way than their neighbours, and holes.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

namespace filum::mesh {

// A hash of a triangle's sides, which cancel out against the same sides run the other way: sums to 0 over a closed
// mesh.
std::uint64_t imbalance(const Triangle& t);

// True if every edge is passed as often one way as the other: the surface is closed, and all of it faces one way.
// By a sum of 64-bit hashes that cancel out: takes one pass and no memory, and errs once in 2^64.
bool is_closed(const Mesh& mesh);

// Turns round triangles that disagree with their neighbours across edges of two triangles, and, if `torn`, across
// gaps: between rims that run beside each other, a quarter of their length apart at most.  The larger area of what
// hangs together keeps its way.  Notes how many.  Does nothing to a closed mesh.
void face_one_way(Mesh& mesh, bool torn, Notes& notes);

struct Hole {
    double area = 0; // mm2, of its lid
    Vec3 middle;
};

// Lids for the holes of a mesh: a fan from the middle of each hole's rim.  Not part of the mesh; its vertices are.
struct Lids {
    std::vector<Triangle> triangles;
    std::vector<Hole> holes;
};

// Finds the holes whose lids are small beside the shell that they are in (at most 0.6 of its area: the outline of a
// sheet is no hole), appends their middles to mesh.vertices and returns their lids, by ascending first vertex.
Lids lids(Mesh& mesh);

} // namespace filum::mesh
