// The winding number of a surface, open or closed, round a point.
#pragma once

#include "mesh/mesh.hpp"

#include <span>

namespace filum::mesh {

// The generalised winding number (Jacobson, Kavan and Sorkine-Hornung 2013): the signed solid angle of the triangles
// seen from a point, divided by that of the whole sphere. For a closed mesh it is a whole number. For an open one it is
// near 1 inside and near 0 outside, and 1/2 where a smooth cap would close the holes.
class Winding {
  public:
    // Builds the tree over the triangles of the mesh and those of `more`, which use its vertices. Takes n log n time.
    // Keeps no reference to the mesh.
    Winding(const Mesh& mesh, std::span<const Triangle> more);

    // The winding number round `p`, within 0.01. Distant triangles are approximated as dipoles (Barill et al. 2018).
    [[nodiscard]] double at(const Vec3& p) const;

  private:
    struct Corner3 {
        Vec3 a, b, c;
    };
    struct Node {
        Vec3 middle, dipole;                // the centre of the area, and the area vector, mm2
        double radius = 0;                  // mm from the middle to the farthest corner
        std::uint32_t first = 0, count = 0; // leaf: triangles [first, first + count); else children first, first + 1
    };
    void split(std::uint32_t node, std::uint32_t first, std::uint32_t last);

    std::vector<Corner3> triangles_;
    std::vector<Node> nodes_;
};

} // namespace filum::mesh
