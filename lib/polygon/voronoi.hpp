// The Voronoi diagram of a region's outline.  Private to lib/polygon.
#pragma once

#include "base/none.hpp"
#include "polygon/sites.hpp"

#include <cstdint>
#include <vector>

namespace filum::polygon {

// Cells of the sites' segments and of their vertices, parted by edges.  Edge e runs along the border of its cell, which
// lies on its left, from vertex `from`[e] to that of its twin e ^ 1; kNone where it runs on for ever.
struct Diagram {
    std::vector<Vec2> vertex; // grid units, as Sites::at
    // per edge
    std::vector<std::uint32_t> from, prev; // prev: the edge before it around its cell
    std::vector<std::uint32_t> cell;
    std::vector<char> between_sites; // else it parts a segment's cell from that of the segment's own end
    // per cell
    std::vector<std::uint32_t> segment;
    enum class Part : char { segment, first_end, second_end };
    std::vector<Part> part; // of that segment

    [[nodiscard]] std::uint32_t edges() const { return static_cast<std::uint32_t>(from.size()); }
    [[nodiscard]] std::uint32_t to(std::uint32_t e) const { return from[e ^ 1]; }
};

// Boost.Polygon's diagram of the sites' segments: that of boost::polygon::construct_voronoi, sooner, as the circles
// that its sweep asks for come from circles.hpp where they can.  Throws Error(failure) if Boost's diagram has edges
// without twins.
Diagram voronoi(const Sites& sites);

} // namespace filum::polygon
