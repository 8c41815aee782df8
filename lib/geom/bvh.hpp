// Things in space by their boxes: those that meet a box, and those near a point.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <vector>

namespace filum::geom {

// A bounding volume hierarchy over boxes that are numbered in the order they came.  Nodes are halved by number, along
// the axis in which the middles of their boxes lie farthest apart; equal middles: by number.  n log n to build, as the
// k-d tree of Bentley 1975; a look-up takes log n and what it finds, if boxes overlap little.
class Bvh {
  public:
    explicit Bvh(const std::vector<Box3>& boxes);

    // Calls f(i) for every box that meets `box`, borders included; in an order that depends on the boxes alone.
    template <class F>
    void visit(const Box3& box, const F& f) const {
        std::uint32_t stack[64], depth = 0; // one more than levels: nodes are halved, so there are 32 at most
        if (!nodes_.empty()) stack[depth++] = 0;
        while (depth > 0) {
            const Node& n = nodes_[stack[--depth]];
            if (!meet(n.box, box)) continue;
            for (std::uint32_t k = n.first; k < n.first + n.count; ++k)
                if (meet(boxes_[k], box)) f(order_[k]);
            if (n.count > 0) continue;
            stack[depth++] = n.first + 1;
            stack[depth++] = n.first;
        }
    }

    // Calls bound = f(i) for every box that is not farther from `p` than the bound is then; near ones mostly come
    // first.  In which order boxes come depends on the boxes alone.
    template <class F>
    void near(const Vec3& p, double bound, const F& f) const {
        if (!nodes_.empty() && distance(nodes_[0].box, p) <= bound) descend(0, p, bound, f);
    }

  private:
    struct Node {
        Box3 box;
        std::uint32_t first, count; // leaf: boxes order_[first, first + count); else children `first`, `first` + 1
    };
    struct Middle {
        double at; // along the axis that is halved
        std::uint32_t box;
    };
    void split(const std::vector<Box3>& boxes, std::uint32_t node, std::vector<Middle>& room);

    template <class F>
    void descend(std::uint32_t at, const Vec3& p, double& bound, const F& f) const {
        const Node& n = nodes_[at];
        for (std::uint32_t k = n.first; k < n.first + n.count; ++k)
            if (distance(boxes_[k], p) <= bound) bound = f(order_[k]);
        if (n.count > 0) return;
        std::uint32_t a = n.first, b = n.first + 1;
        double da = distance(nodes_[a].box, p), db = distance(nodes_[b].box, p);
        if (db < da) {
            std::swap(a, b);
            std::swap(da, db);
        }
        if (da <= bound) descend(a, p, bound, f);
        if (db <= bound) descend(b, p, bound, f);
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
    std::vector<Box3> boxes_; // in that order
};

} // namespace filum::geom
