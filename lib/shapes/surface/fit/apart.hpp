// The distance between two surfaces.
#pragma once

#include "surface/curve/locate.hpp"

namespace filum::surface::fit {

struct Deviation {
    double far = -1; // mm
    Vec3 at;
    std::uint32_t nearest = kNone; // triangle of the other surface
};

// Per triangle of `from` its point farthest from the surface of `to`, among its corners, its middle, and points on its
// sides at most `step` mm apart, up to a hundred per side; ties: the first. Shared points belong to the first
// triangle; a triangle without own points has distance -1.
std::vector<Deviation> deviations(const Surface& from, const curve::Locator& to, double step);

} // namespace filum::surface::fit
