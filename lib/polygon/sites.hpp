// The outline of a region as the integer segments that its Voronoi diagram is made of.
#pragma once

#include "polygon/loops.hpp"
#include "polygon/simple.hpp"

#include <cstdint>
#include <vector>

namespace filum::polygon {

// Segment i runs from vertex i to vertex next[i], solid on its left; coordinates in grid units (simple.hpp) from
// `origin`.
struct Sites {
    Vec2 origin; // mm
    std::vector<std::int32_t> x, y;
    std::vector<std::uint32_t> next, prev;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] Vec2 at(std::size_t i) const { return {static_cast<double>(x[i]), static_cast<double>(y[i])}; }
};

// The outline of `region` (outer loop, then holes) with fewer vertices, none removed that lies farther than `tolerance`
// mm from the result; no straight angles, no vertex twice, and no two segments meet but at the vertex between
// neighbours.  Where simplifying would make the outline touch itself, less is removed; where it touches itself as it
// is, the region is grown by kGrowBy first, or by four, sixteen, ... times as much until it does not touch itself.
// Empty if nothing is left.  Throws Error(failure) for a region wider than 100 m.
Sites sites_of(const Loops& region, double tolerance);

inline constexpr double kGrowBy = 0.001;   // mm: far below any bead, ten grid units
inline constexpr double kGrowAtMost = 1.0; // mm

// The outline of `region` grown by `by` mm; empty where that touches itself.
Sites grown_sites_of(const Loops& region, double by);

} // namespace filum::polygon
