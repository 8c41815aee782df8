// The nearest of many points in space.
#pragma once

#include "geom/bvh.hpp"

#include <span>

namespace filum::geom {

class PointTree {
  public:
    explicit PointTree(std::vector<Vec3> points) : points_(std::move(points)), tree_(boxes(points_)) {}

    struct Nearest {
        std::uint32_t index = ~std::uint32_t{0}; // ~0: none
        double distance = std::numeric_limits<double>::infinity();
    };
    // The point nearest to `p`; ties: the first. None if all are farther than `reach` mm.
    [[nodiscard]] Nearest nearest(const Vec3& p, double reach = std::numeric_limits<double>::infinity()) const {
        Nearest best;
        tree_.near(p, reach, [&](std::uint32_t i) {
            const double d = distance(points_[i], p);
            if (d <= reach && (d < best.distance || (d == best.distance && i < best.index))) best = {i, d};
            return std::min(reach, best.distance);
        });
        return best;
    }

    [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }

  private:
    static std::vector<Box3> boxes(std::span<const Vec3> points) {
        std::vector<Box3> out;
        out.reserve(points.size());
        for (const Vec3& p : points) out.push_back({p, p});
        return out;
    }

    std::vector<Vec3> points_;
    Bvh tree_;
};

} // namespace filum::geom
