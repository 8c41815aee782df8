// The rims of a mesh, as the search for seams sees them; private to lib/shapes/mesh.
#pragma once

#include "mesh/mesh.hpp"
#include "mesh/place.hpp"
#include "mesh/seams.hpp"
#include "mesh/sides.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace filum::mesh {

inline constexpr double kAlong = 0.9; // cosine: two sides with a larger one run in the same direction
// Cosine: triangles on one side with more similar directions are copies, not neighbours.
inline constexpr double kCopies = 0.9;

// The sides with one triangle, and data of their ends.
class SeamRims {
  public:
    // `most` is the largest distance of rims that are joined; vertices within `same` of each other are one point. mm
    SeamRims(const Mesh& mesh, double most, double same) : mesh_(mesh), most_(most), same_(same) {
        const auto sides = half_edges(mesh);
        each_edge(sides, [&](std::size_t i, std::size_t j) {
            if (j - i == 1) sides_.push_back(sides[i].side);
        });
        std::sort(sides_.begin(), sides_.end());
        for (std::uint32_t i = 0; i < sides_.size(); ++i)
            for (const std::uint32_t v : {tail(i), head(i)}) ends_.emplace_back(v, i);
        std::sort(ends_.begin(), ends_.end());
        for (const auto& [v, i] : ends_)
            if (vertices_.empty() || vertices_.back() != v) vertices_.push_back(v);
        measure();
    }

    [[nodiscard]] std::size_t size() const { return sides_.size(); }
    [[nodiscard]] std::uint32_t half_edge(std::uint32_t i) const { return sides_[i]; }
    [[nodiscard]] const std::vector<std::uint32_t>& vertices() const { return vertices_; }
    [[nodiscard]] std::uint32_t tail(std::uint32_t i) const { return corner(i, 0); }
    [[nodiscard]] std::uint32_t head(std::uint32_t i) const { return corner(i, 1); }
    [[nodiscard]] std::uint32_t apex(std::uint32_t i) const { return corner(i, 2); }
    [[nodiscard]] const Vec3& at(std::uint32_t vertex) const { return mesh_.vertices[vertex]; }
    [[nodiscard]] double length(std::uint32_t i) const { return distance(at(tail(i)), at(head(i))); }
    // The largest distance from vertex k of vertices() to another rim that is joined to it, mm.
    [[nodiscard]] double reach(std::size_t k) const { return std::min(most_, kSeamOfSide * shortest_[k]); }
    [[nodiscard]] double most() const { return most_; }
    [[nodiscard]] std::uint32_t triangle(std::uint32_t i) const { return sides_[i] / 3; }
    [[nodiscard]] std::uint32_t other_end(std::uint32_t i, std::uint32_t vertex) const {
        return tail(i) == vertex ? head(i) : tail(i);
    }

    // Calls visit(side) for the rim's sides at a vertex.
    template <class Visit>
    void each_side(std::uint32_t vertex, const Visit& visit) const {
        auto it = std::lower_bound(ends_.begin(), ends_.end(), std::pair{vertex, 0U});
        for (; it != ends_.end() && it->first == vertex; ++it) visit(it->second);
    }

    [[nodiscard]] Vec3 direction(std::uint32_t i) const { return geom::unit(at(head(i)) - at(tail(i)), {}); }
    // The unit vector from a side into its triangle.
    [[nodiscard]] Vec3 inwards(std::uint32_t i) const {
        const Vec3 d = direction(i), p = at(apex(i)) - at(tail(i));
        return geom::unit(p - dot(p, d) * d, {});
    }
    // True if two sides that lie beside each other may form a seam.
    [[nodiscard]] bool may_meet(std::uint32_t i, std::uint32_t j) const {
        return sides_[i] / 3 != sides_[j] / 3 && std::abs(dot(direction(i), direction(j))) > kAlong &&
               dot(inwards(i), inwards(j)) < kCopies;
    }
    // True if a seam may lead through both vertices: each has a side that runs in the same direction.
    [[nodiscard]] bool may_meet_at(std::uint32_t u, std::uint32_t v) const {
        bool out = false;
        each_side(u, [&](std::uint32_t i) {
            each_side(v, [&](std::uint32_t j) {
                const bool same_way = (tail(i) == u) == (tail(j) == v);
                const double along = dot(direction(i), direction(j));
                out = out || ((same_way ? along : -along) > 0 && may_meet(i, j));
            });
        });
        return out;
    }

  private:
    [[nodiscard]] std::uint32_t corner(std::uint32_t i, std::uint32_t k) const {
        return mesh_.triangles[sides_[i] / 3][(sides_[i] + k) % 3];
    }
    void measure() {
        std::vector<std::uint32_t> number(mesh_.vertices.size(), kNoSide);
        for (std::uint32_t k = 0; k < vertices_.size(); ++k) number[vertices_[k]] = k;
        shortest_.assign(vertices_.size(), std::numeric_limits<double>::infinity());
        for (const Triangle& t : mesh_.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                for (const std::uint32_t v : {t[k], t[(k + 1) % 3]}) {
                    const double length = distance(at(t[k]), at(t[(k + 1) % 3]));
                    if (number[v] != kNoSide && length > same_)
                        shortest_[number[v]] = std::min(shortest_[number[v]], length);
                }
    }

    const Mesh& mesh_;
    double most_, same_;
    std::vector<std::uint32_t> sides_;                          // half-edges
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends_; // a vertex, and the index of a side that ends there
    std::vector<std::uint32_t> vertices_;                       // ascending
    std::vector<double> shortest_;                              // per vertex of vertices_: its shortest side, mm
};

} // namespace filum::mesh
