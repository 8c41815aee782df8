// Finds the point of an area that is farthest from other areas.
#pragma once

#include "polygon/region.hpp"

#include <optional>
#include <span>

namespace filum::regions {

struct Farthest {
    double reach = 0; // mm to the nearest of the others
    geom::Vec2 at;
};

// The point of `area` farthest from `others`, to `tolerance` mm; nothing if it is not farther than `least`. Infinitely
// far if there are no others. Tie: the first one found. Vertices of `area` come first, in their order. If a part of the
// area may be farther than these, the middles of ever smaller squares over it follow, first of those that may hold the
// farthest point.
std::optional<Farthest> farthest(const polygon::Loops& area, std::span<const polygon::Region> others, double least,
                                 double tolerance);

} // namespace filum::regions
