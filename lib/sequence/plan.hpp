// The best order that a budget finds, and the best bound.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

struct Plan {
    Order order;
    Cost cost;
    Index path_cover = 0, relaxation = 0; // strokes that each proves, 0 where there was no need to ask
    Index bound = 0;                      // no order has fewer strokes
    bool complete = false;                // a search left nothing out
    std::uint64_t steps = 0;              // taken of the budget
};

// Part by connected part: layer order, the greedy ones, then in turns searches and bounds until they meet or the part's
// share of `budget` steps is taken (by regions; what a part leaves goes to the larger ones).  The strokes depend on the
// graph alone, not on how its nodes are numbered or where they lie; their order is by arranged().
Plan plan(const Graph& g, const Columns& columns, std::uint64_t budget);

// Layer order and what bounds it without a head.
Plan layer_plan(const Graph& g);

} // namespace filum::sequence
