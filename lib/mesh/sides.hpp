// The sides of triangles by the edges that they lie on.
#pragma once

#include "mesh/mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace filum::mesh {

// Of the area of what bounds a solid: a few holes do not matter, a sheet has no volume.
inline constexpr double kOpenShare = 0.05;

inline constexpr std::uint32_t kNoSide = ~std::uint32_t{0};

// Side k of triangle t, from its corner k to the next one, is side 3t + k.
struct HalfEdge {
    std::uint64_t key; // both vertices, the lower number in the high half
    std::uint32_t side;
    bool falls; // from the higher number to the lower
    [[nodiscard]] std::uint32_t low() const { return static_cast<std::uint32_t>(key >> 32); }
    [[nodiscard]] std::uint32_t high() const { return static_cast<std::uint32_t>(key); }
};

// By key, then side.
std::vector<HalfEdge> half_edges(const Mesh& mesh);

// Calls visit(first, last) for the half-edges of each edge.
template <class Visit>
void each_edge(const std::vector<HalfEdge>& sides, const Visit& visit) {
    for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
        while (j < sides.size() && sides[j].key == sides[i].key) ++j;
        visit(i, j);
    }
}

// mm2
double area(const Mesh& mesh, const Triangle& t);

} // namespace filum::mesh
