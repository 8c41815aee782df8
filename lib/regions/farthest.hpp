// The point of an area that is farthest from others.
#pragma once

#include "polygon/region.hpp"

#include <optional>
#include <span>

namespace filum::regions {

struct Farthest {
    double reach = 0; // mm to the nearest of the others
    geom::Vec2 at;
};

// The point of `area` farthest from `others`, to `tolerance` mm; none unless it is farther than `least`.  Infinitely
// far if there are no others.  Of several the first found: vertices of `area` in their order, then the middles of ever
// smaller squares, those that may hold the farthest point first.
std::optional<Farthest> farthest(const polygon::Loops& area, std::span<const polygon::Region> others, double least,
                                 double tolerance);

} // namespace filum::regions
