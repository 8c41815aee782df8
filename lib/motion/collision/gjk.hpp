// Distance between two convex sets given by their support points (E. Gilbert, D. Johnson, S. Keerthi, 1988).
#pragma once

#include "geom/vec.hpp"

#include <array>
#include <cmath>
#include <cstddef>

namespace filum::collision {

using geom::Vec3;

// Up to four points, with the point of their hull nearest to the origin.
class Simplex {
  public:
    // Adds `w`, keeps the fewest points that span the place nearest to the origin, and returns that place. (0, 0, 0)
    // if the origin is inside.
    Vec3 add(const Vec3& w);
    [[nodiscard]] bool holds(const Vec3& w) const;

  private:
    std::array<Vec3, 4> point_{};
    std::size_t count_ = 0;
};

// Distance between the sets whose farthest points along d are first(d) and second(d); `start` is the difference of a
// point of the first and one of the second. 0 if they intersect; `cutoff` as soon as it is known to be at least that.
// Relative accuracy 1e-8, up to rounding.
template <class First, class Second>
double gjk_distance(const First& first, const Second& second, const Vec3& start, double cutoff) {
    constexpr int kMost = 100;
    constexpr double kGap = 1e-8, kZero = 1e-18;
    Simplex simplex;
    Vec3 v = start;
    double vv = dot(v, v);
    for (int i = 0; i < kMost && vv > kZero; ++i) {
        const Vec3 w = first(-1 * v) - second(v);
        const double vw = dot(v, w); // all differences are beyond the plane across v through w
        if (vw > 0 && vw * vw >= cutoff * cutoff * vv) return cutoff;
        if (vv - vw <= kGap * vv || simplex.holds(w)) break;
        const Vec3 next = simplex.add(w);
        const double nn = dot(next, next);
        if (i > 0 && nn >= vv) break; // only rounding remains
        v = next;
        vv = nn;
    }
    return vv > kZero ? std::sqrt(vv) : 0;
}

} // namespace filum::collision
