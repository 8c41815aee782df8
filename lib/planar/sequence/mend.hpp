// Reduces the strokes of an order by small changes.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

// Joins the end of a stroke to the start of another to which a link leads, or parts of them: of the regions printed in
// between, those that wait for the first stroke move behind the second, the others before the first. Where that would
// violate a precedence, the strokes are split. A change is kept unless it costs strokes. Changes are drawn by a fixed
// pseudo-random rule, so the result is the same on every machine. Ends at `target` strokes or after `budget` steps,
// which are added to `steps`. `order` keeps every precedence.
void mend(const Graph& g, Order& order, Index target, std::uint64_t budget, std::uint64_t& steps);

} // namespace filum::sequence
