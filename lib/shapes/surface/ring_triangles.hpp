// Triangulates a ring of points.
#pragma once

#include "geom/vec.hpp"
#include "mesh/mesh.hpp"

#include <span>
#include <vector>

namespace filum::surface {

// Triangles between the corners of the ring, given by their indices: a constrained Delaunay triangulation of its
// projection along its vector area. The ring is on their right, like a rim to which they will be joined. Empty if the
// projection crosses or touches itself.
std::vector<mesh::Triangle> ring_triangles(std::span<const geom::Vec3> ring);

} // namespace filum::surface
