// Fewer strokes by small changes of an order.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

// Joins the end of a stroke to the start of another that a link leads to, or parts of them: of what was printed
// between, that which waits for the first goes behind the second, the rest before the first.  Where that would break a
// precedence the strokes are cut there.  A change stays unless it costs strokes; which one is tried next is drawn by a
// fixed rule, so the result is the same on every machine.  Goes on until `target` strokes are reached or `budget` steps
// are taken, which are added to `steps`.  `order` must keep every precedence, and does so afterwards.
void mend(const Graph& g, Order& order, Index target, std::uint64_t budget, std::uint64_t& steps);

} // namespace filum::sequence
