// The intersection of a surface with a triangle mesh.
#pragma once

#include "surface/section.hpp"

namespace filum::surface {

struct Intersection {
    // By triangles of the surface, without duplicates, also for edges that both have.  The side that the mesh faces is
    // on the left of a crossing, the surface is on the left of a rim.
    std::vector<Segment> segments;
    double crossing = 0; // mm of segments where the surface crosses the mesh
    double touching = 0; // mm of segments where a rim runs along the mesh
    double flush = 0;    // mm2 of the surface that lie on the mesh; edges of both are segments there
};

// The lines common to the surface and the mesh, which may be open, self-intersecting or inconsistently oriented:
// - where triangles cross, their common segment; where they are coplanar, the edges of either inside the other
//   (vertices nearer to a plane than 1e-9 of the surface's box are on it);
// - rims of the surface that run along the mesh, as where two surfaces share a border but have different triangles:
//   nearer to the mesh than `near` mm for more than a mean edge, without a bend of 30 degrees. Crossings within 2
//   `near` of these are left out.
// `near` 0: a twentieth of the mean edge of the surface or of the mesh, whichever is longer.
Intersection meet(const Surface& s, const mesh::Mesh& other, double near = 0);

} // namespace filum::surface
