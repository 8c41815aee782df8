// Many parallel rings to one curve in one window: the Fermat double spiral (notes 3a, A5).  Private to lib/fill.
#pragma once

#include "fill/splices.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace filum::fill {

// Lanes side by side: straight rungs meet ring[0], ring[1] ... one after the other.  rung[j][k] is on ring[k]; from
// rung to rung all places advance, so lanes can change over to one another between the rungs without crossing.
struct Strip {
    std::vector<std::uint32_t> ring;
    std::vector<std::vector<Place>> rung;
};

// The rings that a straight line across `ring` at s meets one after the other on both sides, no farther apart than
// neighbours are.  On either side it ends before a ring for which `use` does not hold, which must not hold for `ring`
// nor for the same ring twice.
struct Lanes {
    std::vector<Place> place;
    std::size_t own = 0; // which of them is the place asked for
};
Lanes lanes_across(const RingGraph& graph, std::uint32_t ring, double s, double width,
                   const std::function<bool(std::uint32_t)>& use);

// The strip that reaches `length` mm along the lane asked for, half on either side: as many of the `lanes` about that
// one as run on side by side all the way and are `free` there (ring, s0, s1).  None if fewer than three do.
std::optional<Strip> strip_along(const RingGraph& graph, const Lanes& lanes, double length, double width,
                                 const std::function<bool(const Window&)>& free);

// The windows of the strip's lanes.
std::vector<Window> windows_of(const RingGraph& graph, const Strip& strip);

// All lanes of the strip as one curve, with two turns and n - 2 bends: from the strip's begin to its end every lane
// moves two lanes outwards.  The two outermost, which that squeezes out, turn back into each other; so do the two
// innermost, coming from the other end.  Each bead is as wide as the space that its neighbours leave it.
Splice double_spiral(const RingGraph& graph, const Strip& strip, double width);

} // namespace filum::fill
