// Solids to meet, for the tests of collision.
#pragma once

#include "collision/tree.hpp"

#include <vector>

namespace walls {

using filum::collision::Solid;
using filum::geom::Vec3;

inline Solid triangle(const Vec3& a, const Vec3& b, const Vec3& c) { return {{a, b, c, c}, 0, 0}; }

// An upright rectangle in the plane x = `x`, from y = -50 to 50, from z = -5 to `top`.
inline std::vector<Solid> wall(double x, double top) {
    const Vec3 a{x, -50, -5}, b{x, 50, -5}, c{x, 50, top}, d{x, -50, top};
    return {triangle(a, b, c), triangle(a, c, d)};
}

} // namespace walls
