// Arranges the strokes of an order with less travel or fewer changes of the tool.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

// The strokes of `order` unchanged, always followed by the nearest one whose precedences are printed; or `order`
// itself if that travels less. Starts with the first stroke without precedences. Distances are between centres of
// area; ties: the lower id.
Order arranged(const Graph& g, Order order);

// The strokes of `order` unchanged, with as few changes of the tool as a greedy choice gives: all strokes that need not
// wait are printed before the tool changes. With two tools no order of these strokes has fewer changes. Within a tool
// always the nearest stroke follows. `order` itself if that has no more changes and travels less.
Order by_tools(const Graph& g, Order order);

} // namespace filum::sequence
