// How often a surface, open or closed, winds round a point.
#pragma once

#include "mesh/mesh.hpp"

#include <span>

namespace filum::mesh {

// The generalised winding number (Jacobson, Kavan and Sorkine-Hornung 2013): the solid angle that the triangles are
// seen under, facing outwards, over that of the whole sphere.  Of a closed mesh it is a whole number; of an open one it
// is near 1 within and near 0 without, and passes 1/2 where a smooth cap would close the holes.
class Winding {
  public:
    // Of the triangles of the mesh and some more of its vertices.  n log n.  Refers to nothing.
    Winding(const Mesh& mesh, std::span<const Triangle> more);

    // Within 0.01; what is far is seen from afar, as dipoles (Barill et al. 2018).
    [[nodiscard]] double at(const Vec3& p) const;

  private:
    struct Corner3 {
        Vec3 a, b, c;
    };
    struct Node {
        Vec3 middle, dipole;                // of the area; its vector, mm2
        double radius = 0;                  // mm from the middle to the farthest corner
        std::uint32_t first = 0, count = 0; // leaf: triangles [first, first + count); else children first, first + 1
    };
    void split(std::uint32_t node, std::uint32_t first, std::uint32_t last);

    std::vector<Corner3> triangles_;
    std::vector<Node> nodes_;
};

} // namespace filum::mesh
