// The Voronoi diagram of a region's outline.  Private to lib/polygon.
#pragma once

#include "base/none.hpp"
#include "polygon/sites.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace filum::polygon {

// Cells of the sites' segments and of their vertices, parted by edges.  Edge e runs along the border of its cell, which
// lies on its left, from vertex `from`[e] to that of its twin e ^ 1; kNone where it runs on for ever.
struct Diagram {
    std::vector<Vec2> vertex; // grid units, as Sites::at
    // per edge
    std::vector<std::uint32_t> from,
        prev; // prev: the edge before it around its cell, kNone if that comes from infinity
    std::vector<std::uint32_t> cell;
    std::vector<char> between_sites; // else it parts a segment's cell from that of the segment's own end
    std::vector<char> inside;        // between sites, inside the region, and longer than nothing
    // per cell
    std::vector<std::uint32_t> segment;
    enum class Part : char { segment, first_end, second_end };
    std::vector<Part> part; // of that segment

    [[nodiscard]] std::uint32_t edges() const { return static_cast<std::uint32_t>(from.size()); }
    [[nodiscard]] std::uint32_t to(std::uint32_t e) const { return from[e ^ 1]; }
};

// The vertex of the outline that a cell belongs to, kNone for a segment's.
std::uint32_t vertex_of(const Sites& sites, const Diagram& d, std::uint32_t cell);

// The diagram of the sites' segments, by Boost.Polygon's sweep.  Two things differ from
// boost::polygon::construct_voronoi: the circles that the sweep asks for come from circles.hpp where they can, which is
// faster; and edges without length are removed inside the region only, so that what is inside can be decided by the
// order of the edges round each cell, without a look at coordinates that were rounded.
// The sweep orders circles by rounded numbers. Where the outline comes nearer to itself than the grid is wide, their
// order can be wrong, and the edges then do not part inside from outside: nothing is returned.
std::optional<Diagram> voronoi(const Sites& sites);

} // namespace filum::polygon
