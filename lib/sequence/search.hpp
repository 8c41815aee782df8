// The search for few strokes: breadth by strokes, kept to the most promising states.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

struct Found {
    Order order;
    bool optimal = false;   // no state was ever dropped: nothing needs fewer strokes
    std::uint64_t work = 0; // precedences looked at
};

// A state is a set of printed regions closed under precedence, so it is one height per column.  It is left by a stroke
// that starts at a ready region and goes on while it can.  That suffices, and of two states after equally many strokes
// the larger set is never worse, because:
// - whatever is ready where a stroke ends can only begin a stroke later, so to go on now costs nothing;
// - taking a closed set off an order shortens its strokes from below and breaks none;
// - a stroke that reaches a region with no link upwards may be taken at once, alone: it removes a stroke from any
// order. After every stroke the `width` states with the most printed `weight` stay; ties by first found. Stops without
// an order when `budget` is used up.  States that are equal are found by the bits `hashed` of a hash, then compared:
// fewer bits cost time and change nothing.
Found search(const Graph& g, const Columns& columns, std::span<const double> weight, std::size_t width,
             std::uint64_t budget, std::uint64_t hashed = ~std::uint64_t{0});

// What a region weighs in the search: the nearer the next column that it waits for or that waits for it, the more
// strokes its surroundings cost.
std::vector<double> weights(const Graph& g, const Columns& columns, double base);

} // namespace filum::sequence
