// Where a surface meets a triangle mesh.
#pragma once

#include "surface/section.hpp"

namespace filum::surface {

struct Meeting {
    // By triangles of the surface, what lies on an edge in both; no two the same.  The side that the mesh's triangle
    // faces lies to the left of a crossing, the surface to the left of a rim.
    std::vector<Segment> segments;
    double crossing = 0; // mm of them where the surface crosses the mesh,
    double touching = 0; // and where a rim runs along it
    double flush = 0;    // mm2 of the surface that lies on the mesh; there edges of both are segments
};

// The lines common to the surface and the mesh, whose triangles may be anything (open, crossing, facing any way):
// - where triangles cross, their common segment, and where they lie in one plane, the edges of either within the other;
//   vertices nearer to a plane than 1e-9 of the surface's box lie in it;
// - rims of the surface that run along the mesh, nearer to it than `near` mm for longer than a mean edge without a bend
//   of 30 degrees, as they do where two surfaces share a border and are not triangulated alike.  Crossings within 2
//   `near` of those are left out.
// `near` 0: a twentieth of the mean edge of the surface or of the mesh, whichever is longer.
Meeting meet(const Surface& s, const mesh::Mesh& other, double near = 0);

} // namespace filum::surface
