// Walls, necks and tips too thin for a ring at half a bead's depth (docs/algorithms/fill.md).
#pragma once

#include "polygon/loops.hpp"

#include <cstdint>
#include <vector>

namespace filum::fill {

using polygon::Loops;
struct MedialAxis;

struct FirstRings {
    Loops rings;         // where the outermost bead runs: level 0, solid on the left
    double unplaced = 0; // mm2 of the area beyond these beads: rounded corners, tips (Steiner formula, to about 1 %)
};

// The outermost ring of every part of `area`, at depth width/2 where the wall is at least `width` thick, and at half
// the local half-thickness where it is thinner: there the ring runs up one side and down the other, two lanes of half
// the wall each.  Formally the outline of the union of the discs about the medial axis points x with radius max(r(x) -
// width/2, r(x)/2), which is connected if `area` is, and has as many holes. Corners and tips that reach less than 0.4
// width beyond the discs next to them are left to the rounding of the bead, and what is thinner than 0.03 width of a
// tip is left out.
FirstRings first_rings(const Loops& area, double width, double tolerance);

// The edges of the medial axis that a bead follows in thin walls, by index, ascending: those that begin or end where
// the half-thickness is below 0.55 width, without twigs to corners and tips that reach less than 0.4 width beyond the
// disc at their foot, and with what leads on into thicker parts, up to a half-thickness of 0.95 width.
std::vector<std::uint32_t> thin_edges(const MedialAxis& axis, double width);

} // namespace filum::fill
