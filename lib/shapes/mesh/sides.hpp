// The sides of triangles, sorted by their edges.
#pragma once

#include "mesh/mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace filum::mesh {

// A shell counts as nearly closed if its area vectors sum to at most this fraction of its area. A few holes pass; a
// sheet, which has no volume, does not.
inline constexpr double kOpenShare = 0.05;

inline constexpr std::uint32_t kNoSide = ~std::uint32_t{0};

// Side k of triangle t, from its corner k to the next one, is side 3t + k.
struct HalfEdge {
    std::uint64_t key; // both vertices, the lower number in the high half
    std::uint32_t side;
    bool falls; // runs from the higher vertex number to the lower
    [[nodiscard]] std::uint32_t low() const { return static_cast<std::uint32_t>(key >> 32); }
    [[nodiscard]] std::uint32_t high() const { return static_cast<std::uint32_t>(key); }
};

// All half-edges of a mesh, ordered by key, then by side.
std::vector<HalfEdge> half_edges(const Mesh& mesh);

// Calls visit(first, last) for each edge: its half-edges are sides[first] to sides[last - 1].
template <class Visit>
void each_edge(const std::vector<HalfEdge>& sides, const Visit& visit) {
    for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
        while (j < sides.size() && sides[j].key == sides[i].key) ++j;
        visit(i, j);
    }
}

// The area of a triangle, mm2.
double area(const Mesh& mesh, const Triangle& t);

} // namespace filum::mesh
