// Nearest ones of many points.
#pragma once

#include "baselines/kipping2022/contours.hpp"

namespace filum::baselines::kipping2022 {

// A tree over points, which it keeps.
class Cloud {
  public:
    explicit Cloud(Points points);

    struct Found {
        std::uint32_t index = surface::kNone;
        double distance = std::numeric_limits<double>::infinity(); // mm
    };
    // The point nearest to `p`, the first of equals; none if all are farther than `reach` mm.
    [[nodiscard]] Found nearest(const Vec3& p, double reach = std::numeric_limits<double>::infinity()) const;

    [[nodiscard]] const Points& points() const { return points_; }

  private:
    struct Node {
        Vec3 lo, hi;
        std::uint32_t first, count; // leaf: order_[first, first + count); else children `first`, `first` + 1
    };
    void split(std::uint32_t node);
    [[nodiscard]] static double away(const Node& n, const Vec3& p);

    Points points_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

} // namespace filum::baselines::kipping2022
