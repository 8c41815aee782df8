// Rings that lie side by side, joined to one curve: the double spiral.  Private to lib/rings.
#pragma once

#include "rings/lines.hpp"

#include <functional>
#include <optional>

namespace filum::rings {

// A ring on a ray: of lane `lane`, on the near side of the axis or across it.
struct StackLane {
    std::uint32_t ring = 0;
    int lane = 1;
    bool across = false;
};

// Lanes side by side, from the outline inwards and, where they go on there, across the axis outwards.
using Stack = std::vector<StackLane>;

// A stretch of a ring along one half-edge.
struct Pass {
    std::uint32_t half = 0;
    double share0 = 0, share1 = 1; // of the half-edge
    double s0 = 0, s1 = 0;         // mm along the ring; s1 may lie beyond its length
};

// What stacks are made of.
struct StackGround {
    const Beading* beading = nullptr;
    const Rings* rings = nullptr;
    const RingLengths* lengths = nullptr;
    std::vector<std::vector<Pass>> passes; // per ring, in its order
};
StackGround stack_ground(const Beading& beading, const Rings& rings, const RingLengths& lengths);

// A place on the axis, seen from one side.
struct AxisPlace {
    std::uint32_t half = 0;
    double share = 0; // of the half-edge
};

// Where the ray lies that the ring passes s mm along it, or the nearest one behind; s is taken modulo its length.
// Nothing if the ring follows no half-edge.
std::optional<AxisPlace> ray_at(const StackGround& ground, std::uint32_t ring, double s);

// The lanes on a ray: from the outline to `ring`, which passes it, and if that is the inmost lane there, across the
// axis to the outline on the other side.  `own`: which of them is the ring.
struct StackAt {
    Stack lanes;
    std::size_t own = 0;
};
StackAt lanes_at(const StackGround& ground, std::uint32_t ring, AxisPlace ray);

struct StackOptions {
    double length = 1;     // mm along a ring in which a lane moves, where it has that much between the rays
    double least_void = 0; // mm2: what of a wedge may stay open
    std::function<bool(std::uint32_t, double, double)> free; // ring, s0, s1: not cut out yet
};

// A splice, and how much its outermost and inmost lanes turn meanwhile, rad.
struct StackSplice {
    Splice splice;
    double turning = 0;
};

// The lanes at a ring's ray that lie side by side, and are free, between the rays from `from` to `to`, as one curve
// with two turns: each lane but two moves two lanes outwards there; the two outermost, which that leaves over, share
// the wedge beside them and turn back into each other in it; so do the two inmost at the other end.  Turns leave at
// most `least_void` open, unless lanes would be narrower than a quarter.  All stays between the rings, and nothing
// crosses: lanes move by the same function, one after the other.  Nothing for fewer than two lanes.
std::optional<StackSplice> stack_splice(const StackGround& ground, const StackAt& at, AxisPlace from, AxisPlace to,
                                        const StackOptions& options);

} // namespace filum::rings
