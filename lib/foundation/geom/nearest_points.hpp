// The nearest of a changing set of points.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace filum::geom {

// A k-d tree over points in the plane (V = Vec2) or in space (V = Vec3) that are all known from the start; each is
// present or absent (Bentley 1975). Queries, insertions and removals take about the logarithm of their number.
template <class V>
class NearestPoints {
  public:
    explicit NearestPoints(std::vector<V> points); // all points are absent

    void insert(std::uint32_t i); // precondition: not present
    void remove(std::uint32_t i); // precondition: present
    [[nodiscard]] bool empty() const { return nodes_.empty() || nodes_[0].present == 0; }
    // The number of the present point nearest to p; ties: the lowest. None if no point is present.
    [[nodiscard]] std::optional<std::uint32_t> nearest(V p) const;

  private:
    struct Node {
        std::conditional_t<std::is_same_v<V, Vec2>, Box2, Box3> box;
        std::uint32_t first, last; // of order_
        std::uint32_t below = 0;   // children are below and below + 1; 0: a leaf
        std::uint32_t above = 0;   // parent; the root's is the root
        std::uint32_t present = 0; // number of present points
    };
    void split(std::uint32_t node);
    void count(std::uint32_t i, std::uint32_t change);

    std::vector<V> points_;
    std::vector<std::uint32_t> order_, leaf_; // order_; the leaf of each point
    std::vector<char> present_;
    std::vector<Node> nodes_;
};

extern template class NearestPoints<Vec2>;
extern template class NearestPoints<Vec3>;

} // namespace filum::geom
