// Turning angles along a chain.  Private to lib/absorb.
#pragma once

#include "absorb/chain.hpp"

#include <cmath>

namespace filum::absorb {

// From the segment before node i to the one after it, rad, positive to the left.
inline double turn(const Chain& chain, std::uint32_t i) {
    const Vec2 u = chain.point(i) - chain.point(chain[i].before), v = chain.point(chain[i].next) - chain.point(i);
    return std::atan2(geom::cross(u, v), geom::dot(u, v));
}

inline Vec2 unit(Vec2 v) {
    const double l = geom::norm(v);
    return l > 0 ? (1 / l) * v : Vec2{0, 0};
}

} // namespace filum::absorb
