// The strokes of an order one after the other with less travel.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

// The strokes of `order`, each as it is, the nearest next of those that need not wait; or `order` itself if that
// travels less.  From the first stroke that waits for none; distances are between centres of area, ties to the lower
// id.
Order arranged(const Graph& g, Order order);

} // namespace filum::sequence
