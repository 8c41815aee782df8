// Evenly spread numbers for rays: equal seeds give equal numbers on every machine.
#pragma once

#include "geom/vec.hpp"

#include <cstdint>
#include <numbers>

namespace filum::render {

inline std::uint32_t hash(std::uint32_t v) { // Wellons, "lowbias32"
    v = (v ^ (v >> 16)) * 0x7feb352dU;
    v = (v ^ (v >> 15)) * 0x846ca68bU;
    return v ^ (v >> 16);
}

// A point of the unit square.
struct Square {
    double u = 0, v = 0;
};

// Point k of a sequence that fills the square evenly (Roberts' R2), shifted by the seed's own offset.
inline Square spread(std::uint32_t seed, std::uint32_t k) {
    const std::uint32_t a = hash(seed), b = hash(a); // the sequence in fixed point: overflow keeps the fraction
    return {(a + k * 3242174889U) * 0x1p-32, (b + k * 2447445414U) * 0x1p-32};
}

// A direction around `n` (length 1), distributed with the cosine to `n`.
inline geom::Vec3 around(geom::Vec3 n, Square s) {
    const double sign = n.z >= 0 ? 1 : -1, a = -1 / (sign + n.z), b = n.x * n.y * a; // Duff et al. 2017
    const geom::Vec3 t{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, q{b, sign + n.y * n.y * a, -n.y};
    const double r = std::sqrt(s.u), phi = 2 * std::numbers::pi * s.v;
    return r * std::cos(phi) * t + r * std::sin(phi) * q + std::sqrt(std::max(0.0, 1 - s.u)) * n;
}

} // namespace filum::render
