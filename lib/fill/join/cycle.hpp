// Rings to one closed curve: the exchange construction and double spirals (docs/algorithms/fill.md).
#pragma once

#include "base/note.hpp"
#include "fill/join/splices.hpp"
#include "toolpath/path.hpp"

#include <functional>
#include <vector>

namespace filum::fill::join {

// How a bead is carried at a place: 0 from below, 1 by what is next to it, kHangsMost not at all.
using Hanging = std::function<int(Vec2)>;
inline constexpr int kHangsMost = 2;

// Joins rings along a spanning tree.  Where two rings face each other, both give up a short window of about one bead
// width and two links close the gap, so two closed curves become one (Lemma 1: exchange).  Windows never overlap and
// links never cross a ring; so links do not cross either, which run between two rings in the order of their windows,
// and the result does not cross itself.  Neighbours are found by true segment distance up to
// 2.2 `width`: rings spaced `width` inside a connected erosion then always form one connected graph (Lemma 2).
//
// With `spirals`, stacks of three rings or more become double spirals first: two turns for all of them instead of two
// for each pair, in the order of the rings, each where the most rings lie side by side.
//
// No link crosses `outline` either: rings on both sides of a narrow slot are near, but not neighbours.
//
// With `hung`, links are laid in the air only if rings cannot be joined elsewhere, and at its rim rather than further
// out; rings that run there are in no double spiral.
//
// Returns one closed curve if all rings could be joined, else one per connected group, the longest first.  Rings beside
// open lines (the first of `rings`) become parts of those, which are returned first and in their order; no two of them
// become one.
// Places come first where rings are a bead apart and a bead wide.  Ties: the lower ring, then the earlier place on it.
std::vector<Curve> join_rings(const rings::Rings& rings, double width, const Loops& outline = {}, bool spirals = false,
                              const Hanging& hung = {});

// Adds a note of how many curves there are beside the first: rings that could not be joined.  None if all were.
void note_unjoined(const std::vector<toolpath::Curve>& curves, Notes& notes);

} // namespace filum::fill::join
