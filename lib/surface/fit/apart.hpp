// How far two surfaces are apart.
#pragma once

#include "surface/curve/locate.hpp"

namespace filum::surface::fit {

struct Apart {
    double far = 0; // mm
    Vec3 at;
};

// The nearest places of these points.
std::vector<curve::Place> nearest(const curve::Locator& locator, std::span<const Vec3> points);

// How far `from` is from the surface of `to` where it is farthest, of its vertices, the middles of its triangles, and
// points on its sides at most `step` mm apart, but no more than a hundred on a side; the first of equals.
Apart farthest(const Surface& from, const curve::Locator& to, double step);

} // namespace filum::surface::fit
