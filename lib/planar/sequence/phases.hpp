// Orders with few changes of the tool.
//
// A phase is a stretch of an order that one tool prints. Regions of one phase need no change of the tool between them.
#pragma once

#include "sequence/order.hpp"

#include <functional>

namespace filum::sequence {

// A lower bound on the changes of the tool in any order: along any way of precedences the tool changes as often as the
// regions on it demand, counted from the tool in use at first; and every tool is used. With two tools some order
// reaches it (docs/algorithms/sequence.md#several-tools). 0 for one tool.
Index least_changes(const Graph& g);

// The phases of an order in which the tool changes as late as possible: all that is ready is printed first.
struct Phases {
    std::vector<Index> tool;             // per phase
    std::vector<Index> earliest, latest; // per region: the phases in which it can be printed
};
Phases phases(const Graph& g, Index first_tool);

// Orders with the phases of phases(), one or several for each tool that can come first. `in_phase` orders the regions
// of one phase, given as a graph of their own with its columns.
std::vector<Order> phase_orders(const Graph& g, const Columns& columns,
                                const std::function<Order(const Graph&, const Columns&)>& in_phase);

} // namespace filum::sequence
