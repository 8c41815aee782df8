// Search for the nearest triangle.
#pragma once

#include "geom/bvh.hpp"
#include "mesh/mesh.hpp"

#include <span>

namespace filum::stressfield {

using geom::Box3;
using geom::Vec3;
using mesh::Triangle;

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A unit vector perpendicular to the unit vector `n`.
Vec3 across(const Vec3& n);

// The point of the triangle a b c nearest to `p`, as weights of its corners.
std::array<double, 3> nearest_weights(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p);

struct TriangleHit {
    std::uint32_t triangle = ~std::uint32_t{0}; // none
    double distance = kInfinity;
    std::array<double, 3> weights{};
    Vec3 at;
};

class TriangleTree {
  public:
    TriangleTree(std::span<const Vec3> points, std::span<const Triangle> triangles);

    // The nearest to `p` of those that pass and are nearer than `bound`; ties: the first.
    template <class Pass>
    TriangleHit nearest(const Vec3& p, double bound, const Pass& pass) const {
        TriangleHit out;
        out.distance = bound;
        tree_.near(p, bound, [&](std::uint32_t t) {
            if (pass(t)) improve(out, t, p);
            return out.distance;
        });
        return out;
    }

  private:
    void improve(TriangleHit& hit, std::uint32_t triangle, const Vec3& p) const;
    std::span<const Vec3> points_;
    std::span<const Triangle> triangles_;
    geom::Bvh tree_;
};

} // namespace filum::stressfield
