// Boxes in space, by what they meet.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <vector>

namespace filum::geom {

inline bool meet(const Box3& a, const Box3& b) {
    return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y && a.lo.z <= b.hi.z &&
           b.lo.z <= a.hi.z;
}

// A tree over boxes that are numbered in the order they came.
class BoxTree {
  public:
    explicit BoxTree(std::vector<Box3> boxes);

    // Calls f(i) for every box that meets `box`, borders included; in an order that depends on the boxes alone.
    template <class F>
    void visit(const Box3& box, const F& f) const {
        std::uint32_t stack[64], depth = 0;
        if (!order_.empty()) stack[depth++] = 0;
        while (depth > 0) {
            const Node& n = nodes_[stack[--depth]];
            if (!meet(n.box, box)) continue;
            for (std::uint32_t i = n.first; i < n.first + n.count; ++i)
                if (meet(boxes_[order_[i]], box)) f(order_[i]);
            if (n.count == 0) stack[depth++] = n.first + 1, stack[depth++] = n.first;
        }
    }

  private:
    struct Node {
        Box3 box;
        std::uint32_t first, count; // leaf: boxes order_[first, first + count); else children `first`, `first` + 1
    };
    void split(std::uint32_t node);

    std::vector<Box3> boxes_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

} // namespace filum::geom
