// Beam search for an order with few strokes.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

struct SearchResult {
    Order order;
    bool optimal = false;   // no state was ever dropped: no order has fewer strokes, or as few and fewer tool changes
    std::uint64_t work = 0; // precedences examined
};

// A state is a set of printed regions closed under precedence, that is, one height per column. A transition is a
// stroke that starts at a ready region and continues while it can. This is sufficient, and of two states after equally
// many strokes the larger set is never worse, because:
// - a region that is ready where a stroke ends can only begin a later stroke, so continuing costs nothing;
// - removing a closed set from an order shortens its strokes from below and breaks none;
// - a stroke that reaches a region without a link upwards may be chosen at once, alone, if it needs no change of the
//   tool: it removes a stroke from any order.
// With several tools a state also has the tool in use and the number of changes, and one state replaces another only if
// no order from it changes the tool more often. Of the orders with the fewest strokes the one with the fewest changes
// wins.
// After every stroke the `width` states with the most printed `weight` survive; ties: the first found. Ends without an
// order when `budget` is used up. Equal states are found by `hashed` bits of a hash and then compared; fewer bits cost
// time and change nothing.
SearchResult search(const Graph& g, const Columns& columns, std::span<const double> weight, std::size_t width,
                    std::uint64_t budget, std::uint64_t hashed = ~std::uint64_t{0});

// The weight of a region in the search: the nearer the next column that it waits for or that waits for it, the more
// strokes its surroundings cost.
std::vector<double> weights(const Graph& g, const Columns& columns, double base);

} // namespace filum::sequence
