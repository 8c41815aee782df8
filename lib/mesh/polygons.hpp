// Faces of more than three corners, cut into triangles; private to lib/mesh.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

#include <span>

namespace filum::mesh {

// The faces of a file as they are read.
class Faces {
  public:
    std::vector<Triangle> triangles;

    // Appends a face: a triangle, or a fan from the first corner until cut() looks at the places of the corners.
    void add(std::span<const std::uint32_t> corners);

    // Cuts polygons into triangles, in the place of their fans: two fewer than corners.  A fan from the first corner
    // stays where no triangle of it folds over, as in every convex polygon.  Others are cut ear by ear, seen along the
    // polygon's mean normal, so a polygon may be concave, a little bent, and have holes that a doubled edge leads to.
    // Polygons that cross themselves, seen so, are cut as far as that is possible, with a note.
    // Takes about n log n time for n corners.  Precondition: all corners are vertices of `vertices`.
    void cut(const std::vector<Vec3>& vertices, Notes& notes);

  private:
    struct Polygon {
        std::size_t triangle, first, corners; // its first triangle, its first corner in corners_, and how many
    };
    std::vector<std::uint32_t> corners_;
    std::vector<Polygon> polygons_;
};

} // namespace filum::mesh
