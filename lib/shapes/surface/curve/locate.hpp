// Finds the places of a surface nearest to many points.
#pragma once

#include "geom/bvh.hpp"
#include "surface/curve/line.hpp"

#include <limits>

namespace filum::surface::curve {

// A search tree over the triangles of a surface, which must outlive it.
class Locator {
  public:
    explicit Locator(const Surface& surface);

    // The nearest place; ties: the first triangle.
    [[nodiscard]] Place nearest(const Vec3& p) const { return search(p, nullptr, kFar); }

    // The nearest place on a triangle that faces as `normal` does (less than 90 degrees apart), so that a point of a
    // thin wall is not assigned to the opposite skin. Triangle kNone if there is none within `most` mm.
    [[nodiscard]] Place nearest(const Vec3& p, const Vec3& normal, double most = kFar) const {
        return search(p, &normal, most);
    }

  private:
    static constexpr double kFar = std::numeric_limits<double>::infinity();

    [[nodiscard]] Place search(const Vec3& p, const Vec3* normal, double most) const;

    const Surface& surface_;
    geom::Bvh tree_;
};

} // namespace filum::surface::curve
