// The outline of a region as the integer segments from which its Voronoi diagram is made.
#pragma once

#include "polygon/loops.hpp"
#include "polygon/simple.hpp"

#include <cstdint>
#include <vector>

namespace filum::polygon {

// Segment i runs from vertex i to vertex next[i], solid on its left; coordinates in grid units (simple.hpp) from
// `origin`. `turn` is the direction of the first axis.
struct Sites {
    Vec2 origin;     // mm
    Vec2 turn{1, 0}; // unit
    std::vector<std::int32_t> x, y;
    std::vector<std::uint32_t> next, prev;

    [[nodiscard]] std::size_t size() const { return x.size(); }
    [[nodiscard]] Vec2 at(std::size_t i) const { return {static_cast<double>(x[i]), static_cast<double>(y[i])}; }
    // The place of a point in grid units, mm.
    [[nodiscard]] Vec2 place(Vec2 p) const {
        return origin + (1 / kGridPerMm) * (p.x * turn + p.y * geom::left_of(turn));
    }
};

// The outline of `region` (outer loop, then holes) with fewer vertices; no removed vertex is farther than `tolerance`
// mm from the result. There are no straight angles and no repeated vertices, and two segments meet only at the vertex
// between neighbours. Where simplifying would make the outline touch itself, fewer vertices are removed. Where the
// outline touches itself in the input, the region is grown by kGrowBy, or by four, sixteen, ... times as much, until it
// does not. Empty if nothing is left. Throws Error(bad_input) for a region wider than 100 m.
Sites sites_of(const Loops& region, double tolerance);

inline constexpr double kGrowBy = 0.001;   // mm: far below any bead, ten grid units
inline constexpr double kGrowAtMost = 1.0; // mm

// The outline of `region` grown by `by` mm; empty if that touches itself.
Sites grown_sites_of(const Loops& region, double by);

// The same segments along axes turned by the angle of the unit vector `turn`; vertices move to the new grid, by .7 grid
// units at most. Empty if segments meet then, or if the region is too wide.
Sites turned(const Sites& sites, Vec2 turn);

} // namespace filum::polygon
