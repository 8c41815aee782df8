// Joins rings into one closed curve, by exchanges and double spirals (docs/algorithms/fill.md).
#pragma once

#include "base/note.hpp"
#include "fill/join/splices.hpp"
#include "geom/segment_grid.hpp"
#include "toolpath/path.hpp"

#include <functional>
#include <vector>

namespace filum::fill::join {

// How a bead is carried at a place: 0 from below, 1 by the bead beside it, kHangsMost not at all.
using Hanging = std::function<int(Vec2)>;
inline constexpr int kHangsMost = 2;

// The edges of an outline, and their places in a grid.
struct OutlineEdges {
    std::vector<geom::Segment> edge;
    geom::SegmentGrid grid;
    OutlineEdges(const polygon::Loops& outline, double cell);
};

// Joins rings along a spanning tree. Where two rings face each other, both give up a window of about half a bead width.
// Two links connect the four ends, so two closed curves become one (Lemma 1: exchange).
//
// Windows never overlap and links never cross a ring. Links between two rings keep the order of their windows. So links
// do not cross either, and the result does not cross itself. Neighbours are found by exact segment distance up to 2.2
// `width`. Rings spaced `width` inside a connected erosion always form one connected graph (Lemma 2).
//
// With `spirals`, stacks of three or more rings become double spirals first. A double spiral has two turns instead of
// two for each pair. Stacks are taken in the order of the rings, each where the most rings lie side by side.
//
// No link crosses `outline`: rings on both sides of a narrow slot are near, but not neighbours.
//
// With `hung`, a link hangs in the air only if rings cannot be joined elsewhere, and at the rim of the air first. Rings
// over air are in no double spiral.
//
// Returns one closed curve if all rings could be joined, else one per connected group, the longest first. Open lines
// come first in `rings`; rings beside them become parts of them. They are returned first, in their order, and never
// join each other. Places where rings are a bead apart and a bead wide come first. Ties: the lower ring, then the
// earlier place.
std::vector<Curve> join_rings(const rings::Rings& rings, double width, const OutlineEdges& outline,
                              bool spirals = false, const Hanging& hung = {});
std::vector<Curve> join_rings(const rings::Rings& rings, double width, const Loops& outline = {}, bool spirals = false,
                              const Hanging& hung = {});

// Adds a note with the number of curves after the first: groups of rings that could not be joined.
void note_unjoined(const std::vector<toolpath::Curve>& curves, Notes& notes);

} // namespace filum::fill::join
