// The area under long beads, tile by tile: a tile that beads only pass has a closed form, and rows sweep the others.
// Private to lib/results/metrics/planar.
#pragma once

#include "metrics/planar/cover.hpp"
#include "metrics/planar/row_sections.hpp"

#include <cstddef>
#include <span>

namespace filum::metrics::planar {

// An edge of an outline.
struct OutlineEdge {
    Vec2 lo, hi; // lo.y <= hi.y
    std::uint32_t slot = 0;
};

// Horizontal rows, evenly spaced.
struct Rows {
    double first = 0, spacing = 1; // mm: y of the lowest row
    std::size_t count = 0;
    [[nodiscard]] double at(std::size_t row) const { return first + static_cast<double>(row) * spacing; }
};

// Whether tiles take less time than rows alone: if a bead meets many rows, on average.
bool tiles_pay(std::span<const SweptBead> beads, const Rows& rows);

// The area under `beads` that is not under `below`, both as from swept_beads(), mm2.
double uncovered_by_tiles(std::span<const SweptBead> beads, std::span<const SweptBead> below, const Rows& rows);

// Area, covered and united area of one outline and its beads. `beads` are as from swept_beads(). Takes time for ends of
// beads and of edges, and for the logarithm of lengths.
Cover cover_by_tiles(std::span<const SweptBead> beads, std::span<const OutlineEdge> edges, const Rows& rows);

} // namespace filum::metrics::planar
