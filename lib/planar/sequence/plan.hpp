// The best order and the best bound within a budget.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

struct Plan {
    Order order;
    Cost cost;
    Index path_cover = 0, relaxation = 0; // lower bounds on strokes by each method, 0 if it was not needed
    Index bound = 0;                      // no order has fewer strokes
    Index change_bound = 0;               // no order changes the tool less often
    bool complete = false;                // a search was exhaustive
    std::uint64_t steps = 0;              // taken of the budget
};

// For each connected part: layer order, greedy orders, then alternately searches and bounds until they meet or the
// part's share of `budget` steps is used (by number of regions; what a part leaves goes to larger ones). The number of
// strokes depends on the graph only, not on numbers or positions of nodes; their order is by arranged().
// With several tools the strokes come first, then the changes of the tool; or the other way round (`first`).
Plan plan(const Graph& g, const Columns& columns, std::uint64_t budget, Priority first = Priority::strokes);

// Layer order, with the bound that holds without a head.
Plan layer_plan(const Graph& g);

} // namespace filum::sequence
