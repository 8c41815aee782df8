// The nearest places of a surface, of many points.
#pragma once

#include "surface/curve/line.hpp"

namespace filum::surface::curve {

// A tree of boxes over the triangles of a surface, which must outlive it.
class Locator {
  public:
    explicit Locator(const Surface& surface);

    // The nearest place; of equally near ones that of the first triangle.
    [[nodiscard]] Place nearest(const Vec3& p) const;

    // The nearest place on a triangle that faces as `normal` does (less than 90 degrees between them): so a point of a
    // thin wall is not taken for one of its other skin.  A place with triangle kNone if there is none.
    [[nodiscard]] Place nearest(const Vec3& p, const Vec3& normal) const;

  private:
    struct Node {
        Vec3 lo, hi;
        std::uint32_t first, count; // leaf: triangles order_[first, first + count); else children `first`, `first` + 1
    };
    void split(std::uint32_t node, std::span<const Vec3> middle);
    void search(const Vec3& p, const Vec3* normal, double& least, Place& best) const;

    const Surface& surface_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

} // namespace filum::surface::curve
