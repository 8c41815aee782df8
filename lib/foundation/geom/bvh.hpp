// Boxes in a tree: finds those that meet a box, and those near a point.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <vector>

namespace filum::geom {

// A bounding volume hierarchy over boxes, which are numbered in the order given. Nodes are halved by number of boxes
// along the axis in which the middles are spread most; ties: by number. Takes n log n to build, as the k-d tree of
// Bentley 1975; a query takes log n plus the boxes found, if boxes overlap little.
class Bvh {
  public:
    explicit Bvh(const std::vector<Box3>& boxes);

    // Calls f(i) for every box that meets `box`, borders included. The order depends on the boxes only.
    template <class F>
    void visit(const Box3& box, const F& f) const {
        std::uint32_t stack[64], depth = 0; // enough, as nodes are halved: at most 32 levels
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

    // Calls bound = f(i) for every box whose distance from `p` is at most the current bound, usually near ones first.
    // The order depends on the boxes only.
    template <class F>
    void near(const Vec3& p, double bound, const F& f) const {
        if (!nodes_.empty() && distance(nodes_[0].box, p) <= bound) descend(0, p, bound, f);
    }

  private:
    struct Node {
        Box3 box;
        // leaf: boxes order_[first, first + count); inner node: children first and first + 1
        std::uint32_t first, count;
    };
    struct Middle {
        Vec3 at;
        std::uint32_t box;
    };
    void split(std::uint32_t node, std::vector<Middle>& middles);

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
    std::vector<Box3> boxes_; // in the order of order_
};

} // namespace filum::geom
