// Many parallel rings to one curve at one place: the Fermat double spiral (docs/algorithms/fill.md).  Private to
// lib/fill.
#pragma once

#include "fill/join/splices.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace filum::fill::join {

// Bead widths: rings that are neighbours are nearer to each other (Lemma 2: at most 2), and links no longer.
inline constexpr double kNeighbourReach = 2.2;

// Where a line crosses rings that run side by side, one after the other.  It runs aslant: at each ring, half the angle
// by which lanes bend away from the normal, forwards as it goes inwards.
struct Lanes {
    struct Lane {
        Place at;
        Vec2 inward, forward; // unit, along the normal and along the ring
        double sense = 1;     // 1 if forwards is ahead on the ring, else -1
    };
    std::vector<Lane> lane; // from the right of the ring asked for to its left
    std::size_t own = 0;    // which of them is the one asked for
};

// The lanes about `ring` at s.  On either side they end before a ring too far for a neighbour, one that runs in another
// direction, and one for which `use` does not hold (it must not hold for `ring` nor for the same ring twice).  `ahead`:
// forwards is ahead on `ring`.
Lanes lanes_across(const RingGraph& graph, std::uint32_t ring, double s, bool ahead, double width,
                   const std::function<bool(std::uint32_t)>& use);

// What may not be done.
struct Room {
    std::function<bool(std::uint32_t, double, double)> free; // ring, s0, s1: not cut out yet
    std::function<bool(Vec2, Vec2)> clear;                   // no outline is in the way
};

// As many of the lanes about the one asked for as have room, as one curve with two turns: before the line, and behind
// a second one beside it, lanes stay what they were; from the one to the other each moves two lanes outwards, side by
// side with the others, in two bends of 60 degrees.  The two outermost, which that leaves over, turn back into each
// other before the first line; so do the two innermost behind the second.  None for fewer than three lanes.
std::optional<Splice> double_spiral(const RingGraph& graph, const Lanes& lanes, double width, const Room& room);

} // namespace filum::fill::join
