// Joins parallel rings into one curve at one place: the Fermat double spiral (docs/algorithms/fill.md). Private to
// lib/planar/fill.
#pragma once

#include "fill/join/splices.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace filum::fill::join {

// The largest distance of neighbouring rings, and the greatest length of links, in bead widths. Neighbours are at most
// 2 apart (Lemma 2).
inline constexpr double kNeighbourReach = 2.2;

// The crossings of a line with rings that run side by side, one after the other. At each ring the line leans forwards,
// going inwards, by half the angle at which lanes bend.
struct Lanes {
    struct Lane {
        Place at;
        Vec2 inward, forward; // unit vectors along the normal and along the ring
        double sense = 1;     // 1 if `forward` is the direction of the ring, else -1
    };
    std::vector<Lane> lane; // from the right of the given ring to its left
    std::size_t own = 0;    // index of the given ring
};

// The lanes around `ring` at arc length s. On either side they end before a ring that is too far away, runs in another
// direction, or fails `use`. `use` must fail for `ring` itself, and for a ring that it accepted before. `ahead`: the
// forward direction is that of `ring`. No lanes if `ring` bends too much at s.
Lanes lanes_across(const RingGraph& graph, std::uint32_t ring, double s, bool ahead, double width,
                   const std::function<bool(std::uint32_t)>& use);

// Conditions on windows and links.
struct Room {
    std::function<bool(std::uint32_t, double, double)> free; // ring, s0, s1: true if the stretch is not cut out yet
    std::function<bool(Vec2, Vec2)> clear;                   // true if no outline crosses the segment
};

// Joins as many lanes as have room, around the given one, into one curve with two turns. Lanes stay as they are before
// the line, and behind a second line beside it. Between the two lines each lane moves two lanes outwards, side by side
// with the others, in two bends of 60 degrees. That leaves the two outermost lanes over: they turn back into each other
// before the first line. The two innermost turn back behind the second. nullopt for fewer than three lanes.
std::optional<Splice> double_spiral(const RingGraph& graph, const Lanes& lanes, double width, const Room& room);

} // namespace filum::fill::join
