// How far two surfaces are apart.
#pragma once

#include "surface/curve/locate.hpp"

namespace filum::surface::fit {

struct Apart {
    double far = -1; // mm
    Vec3 at;
    std::uint32_t nearest = kNone; // triangle of the other surface
};

// Per triangle of `from`, which of its points is farthest from the surface of `to`, and how far: of its corners, its
// middle, and points on its sides at most `step` mm apart, but no more than a hundred on a side.  The first of equals;
// a point that triangles share is the first one's, and a triangle is -1 mm far if all are others'.
std::vector<Apart> apart(const Surface& from, const curve::Locator& to, double step);

} // namespace filum::surface::fit
