// Triangulates faces of more than three corners; private to lib/shapes/mesh.
#pragma once

#include "base/note.hpp"
#include "mesh/mesh.hpp"

#include <span>

namespace filum::mesh {

// Collects the faces of a file while it is read.
class Faces {
  public:
    std::vector<Triangle> triangles;

    // Appends a face: a triangle, or a fan from the first corner. cut() revises the fans once the positions of the
    // corners are known.
    void add(std::span<const std::uint32_t> corners);

    // Triangulates the polygons, in the place of their fans; a polygon of n corners gives n - 2 triangles. A fan from
    // the first corner stays if none of its triangles folds over, as in every convex polygon. Other polygons are cut by
    // ear clipping, projected along their mean normal. So a polygon may be concave, slightly bent, and have holes that
    // a doubled edge leads to. A polygon whose projection crosses itself is cut as far as possible, with a note. Takes
    // about n log n time for n corners. Precondition: all corners are vertices of `vertices`.
    void cut(const std::vector<Vec3>& vertices, Notes& notes);

  private:
    struct Polygon {
        std::size_t triangle, first, corners; // first triangle, first corner in corners_, number of corners
    };
    std::vector<std::uint32_t> corners_;
    std::vector<Polygon> polygons_;
};

} // namespace filum::mesh
