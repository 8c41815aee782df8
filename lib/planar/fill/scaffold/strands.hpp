// Strands across an area, and the stretches of its boundary between their ends: the graph in which a scaffold's layer
// is routed.
#pragma once

#include "geom/polyline.hpp"
#include "polygon/loops.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace filum::fill::scaffold {

using geom::Vec2;
using polygon::Loops;

// A stretch of the boundary from one node to the next along its loop. `line` includes both ends.
struct Arc {
    std::uint32_t from = 0, to = 0;
    std::vector<Vec2> line;
    double length = 0; // mm
};

// Node 2k is the left end of strand k, node 2k + 1 its right end. A node after those is a place to begin at.
struct StrandGraph {
    std::size_t strands = 0;                           // ascending y, then x
    std::vector<Vec2> node;                            //
    std::vector<Arc> arcs;                             //
    std::vector<std::array<std::uint32_t, 2>> arcs_at; // per node: the arc that ends there, the arc that begins there
    std::optional<std::uint32_t> start;                // the node to begin at
    std::vector<std::vector<Vec2>> line;               // of strands that bend; empty: all are straight

    [[nodiscard]] double strand_length(std::size_t k) const {
        return line.empty() ? node[2 * k + 1].x - node[2 * k].x : geom::length(line[k]);
    }
    [[nodiscard]] std::vector<Vec2> strand(std::size_t k) const {
        return line.empty() ? std::vector<Vec2>{node[2 * k], node[2 * k + 1]} : line[k];
    }
};

// The strands and boundary arcs of `area`. Strands are the stretches of the lines y = const (ascending) inside `area`
// that are at least `shortest` mm long. The boundary loops on which they end are cut there, and with `start` also at
// the place nearest to it. An edge belongs to the lines with lower <= y < upper.
StrandGraph strand_graph(const Loops& area, std::span<const double> y, double shortest, std::optional<Vec2> start);

} // namespace filum::fill::scaffold
