// Repairs along the edges of a surface: triangles that face against their neighbours, and holes.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

namespace filum::mesh {

// A hash of the directed sides of a triangle. A side and its reverse cancel out, so the hashes of a closed mesh sum to
// 0.
std::uint64_t imbalance(const Triangle& t);

// True if triangles run along every edge equally often in both directions: the surface is closed and consistently
// oriented. The test sums 64-bit hashes that cancel out. It takes one pass and no memory, and errs once in 2^64.
bool is_closed(const Mesh& mesh);

// Flips triangles that disagree with their neighbours, across edges of exactly two triangles. If `torn`, it also
// compares triangles across gaps: between rims that run beside each other, at most a quarter of their length apart. In
// each connected part the orientation of the larger area wins. Adds a note with the number of flipped triangles. Does
// nothing to a closed mesh.
void face_one_way(Mesh& mesh, bool torn, Notes& notes);

struct Hole {
    double area = 0; // mm2, of its lid
    Vec3 middle;
};

// Lids for the holes of a mesh: a fan around the middle of each hole's rim. The mesh holds the vertices of the lids,
// but not their triangles.
struct Lids {
    std::vector<Triangle> triangles;
    std::vector<Hole> holes;
};

// Finds the holes of a mesh, appends their middles to mesh.vertices and returns their lids, by ascending first vertex.
// A rim counts as a hole if its lid has at most 0.6 of the area of its shell. A larger one is the outline of a sheet.
Lids lids(Mesh& mesh);

} // namespace filum::mesh
