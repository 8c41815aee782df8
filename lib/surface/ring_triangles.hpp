// A ring of points closed by triangles.
#pragma once

#include "geom/vec.hpp"
#include "mesh/mesh.hpp"

#include <span>
#include <vector>

namespace filum::surface {

// Triangles between the corners of the ring, by their places in it, as a constrained Delaunay triangulation of what is
// seen along the vector area of the ring; the ring is to their right, as a rim is that they are joined to. None
// if the ring crosses or touches itself, seen so.
std::vector<mesh::Triangle> ring_triangles(std::span<const geom::Vec3> ring);

} // namespace filum::surface
