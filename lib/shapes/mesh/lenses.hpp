// Gaps between two rims that meet in two points and approximate the same curve; private to lib/shapes/mesh.
#pragma once

#include "mesh/seam_rims.hpp"

namespace filum::mesh {

// A vertex that lies on a side.
struct OnSide {
    std::uint32_t side;
    double part; // position on the side, as a fraction from its tail
    std::uint32_t vertex;
};

// The vertices where two parts of a surface touch that share no side there: two fans of triangles, two rims.
class PinchedVertices {
  public:
    PinchedVertices(const Mesh& mesh, const SeamRims& rims);

    [[nodiscard]] const std::vector<std::uint32_t>& all() const { return vertices_; } // ascending
    // True if the vertex is pinched, and the rim sides i and j belong to different parts there.
    [[nodiscard]] bool apart(std::uint32_t vertex, std::uint32_t i, std::uint32_t j) const;

  private:
    std::vector<std::uint32_t> vertices_;
    std::vector<std::array<std::uint32_t, 2>> first_fan_; // per vertex: the rim sides of one fan
};

// The vertices that each of the two rims of a lens must take over from the other one. A lens is a gap between two
// chains of rim sides with common ends; no vertex is farther from the other chain than rims may be that are joined, or
// than an arc over its side rises whose height is kSeamOfSide of its length.
std::vector<OnSide> across_lenses(const Mesh& mesh, const SeamRims& rims);

} // namespace filum::mesh
