// Arranges the strokes of an order with less travel or fewer changes of the tool.
#pragma once

#include "sequence/order.hpp"

#include <span>

namespace filum::sequence {

// The strokes of `order` unchanged, always followed by the nearest one whose precedences are printed; or `order`
// itself if that travels less. Starts with the first stroke without precedences. Distances are between centres of
// area; ties: the lower id.
Order arranged(const Graph& g, Order order);

// The strokes of `order` unchanged, with as few changes of the tool as a greedy choice gives: all strokes that need not
// wait are printed before the tool changes. With two tools no order of these strokes has fewer changes. Within a tool
// always the nearest stroke follows. `order` itself if that has no more changes and travels less.
Order by_tools(const Graph& g, Order order);

// As many strokes as `order` has, from the inside outwards: strokes rather go on to an inner region, and a stroke waits
// while another one that it surrounds is ready. Among the others the nearest follows. `around`: per region the one
// whose hole holds it, kNone if none. `order` itself for several tools, or if the new order has more strokes.
Order from_inside(const Graph& g, Order order, std::span<const Index> around);

// The number of strokes that begin before a stroke that they surround.
std::size_t outer_first(const Graph& g, const Order& order, std::span<const Index> around);

} // namespace filum::sequence
