// Things in space by their boxes: a tree that finds those near a point.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <vector>

namespace filum::stressfield {

using geom::Vec3;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Box3 {
    Vec3 lo{kInfinity, kInfinity, kInfinity};
    Vec3 hi{-kInfinity, -kInfinity, -kInfinity};
    void add(const Vec3& p) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
    }
    // 0 within.
    [[nodiscard]] double distance(const Vec3& p) const {
        const Vec3 out{std::max({0.0, lo.x - p.x, p.x - hi.x}), std::max({0.0, lo.y - p.y, p.y - hi.y}),
                       std::max({0.0, lo.z - p.z, p.z - hi.z})};
        return norm(out);
    }
};

class BoxTree {
  public:
    explicit BoxTree(const std::vector<Box3>& boxes);

    // Calls bound = visit(index) for every box that is not farther from `p` than the bound is then; near ones mostly
    // come first.  In which order boxes come depends on the boxes alone.
    template <class Visit>
    void near(const Vec3& p, double bound, const Visit& visit) const {
        if (!nodes_.empty()) descend(0, p, bound, visit);
    }

  private:
    struct Node {
        Box3 box;
        std::uint32_t first = 0, count = 0; // of order_, for a leaf; else count is 0 and first is the second child
    };
    std::uint32_t build(const std::vector<Box3>& boxes, std::uint32_t first, std::uint32_t count);

    template <class Visit>
    void descend(std::uint32_t at, const Vec3& p, double& bound, const Visit& visit) const {
        const Node& node = nodes_[at];
        if (node.count > 0) {
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
                if (boxes_[k].distance(p) <= bound) bound = visit(order_[k]);
            return;
        }
        std::uint32_t a = at + 1, b = node.first;
        double da = nodes_[a].box.distance(p), db = nodes_[b].box.distance(p);
        if (db < da) std::swap(a, b), std::swap(da, db);
        if (da <= bound) descend(a, p, bound, visit);
        if (db <= bound) descend(b, p, bound, visit);
    }

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
    std::vector<Box3> boxes_; // in that order
};

} // namespace filum::stressfield
