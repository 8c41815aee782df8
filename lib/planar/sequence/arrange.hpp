// Arranges the strokes of an order with less travel.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

// The strokes of `order` unchanged, always followed by the nearest one whose precedences are printed; or `order`
// itself if that travels less. Starts with the first stroke without precedences. Distances are between centres of
// area; ties: the lower id.
Order arranged(const Graph& g, Order order);

} // namespace filum::sequence
