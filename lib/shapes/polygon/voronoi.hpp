// The Voronoi diagram of a region's outline.  Private to lib/shapes/polygon.
#pragma once

#include "base/none.hpp"
#include "polygon/sites.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace filum::polygon {

// The cells of the sites' segments and of their vertices, separated by edges. Edge e has its cell on its left. It runs
// from vertex `from`[e] to that of its twin e ^ 1; kNone where it is infinite.
struct Diagram {
    std::vector<Vec2> vertex; // grid units, as Sites::at
    // per edge
    std::vector<std::uint32_t> from,
        prev; // prev: the edge before it around its cell, kNone if it comes from infinity
    std::vector<std::uint32_t> cell;
    std::vector<char> between_sites; // false: between a segment's cell and that of its own end
    std::vector<char> inside;        // between sites, inside the region, and of some length
    // per cell
    std::vector<std::uint32_t> segment;
    enum class Part : char { segment, first_end, second_end };
    std::vector<Part> part; // of that segment

    [[nodiscard]] std::uint32_t edges() const { return static_cast<std::uint32_t>(from.size()); }
    [[nodiscard]] std::uint32_t to(std::uint32_t e) const { return from[e ^ 1]; }
};

// The vertex of the outline to which a cell belongs; kNone for the cell of a segment.
std::uint32_t vertex_of(const Sites& sites, const Diagram& d, std::uint32_t cell);

// The diagram of the sites' segments, by Boost.Polygon's sweep. Two things differ from
// boost::polygon::construct_voronoi. Circles come from circles.hpp where possible, which is faster. Edges without
// length are removed only inside the region. So the order of the edges round each cell decides what is inside, and
// rounded coordinates do not count.
//
// The sweep orders circles by rounded numbers. Where the outline comes nearer to itself than a grid unit, their order
// can be wrong. The edges then do not separate inside from outside, and nothing is returned.
std::optional<Diagram> voronoi(const Sites& sites);

} // namespace filum::polygon
