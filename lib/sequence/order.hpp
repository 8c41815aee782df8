// An order of all regions, what it costs, and whether it can be printed.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

using Order = std::vector<Index>;

// True if a stroke can go on from u to v, printed next.
bool continues(const Graph& g, Index u, Index v);

struct Cost {
    Index strokes = 0;
    double travel = 0; // mm between centres of area, summed over the starts of strokes but the first
    friend bool operator==(const Cost&, const Cost&) = default;
    friend auto operator<=>(const Cost&, const Cost&) = default;
};
Cost cost(const Graph& g, std::span<const Index> order);

// Throws Error(failure, "internal error: ...") unless `order` holds every region once and keeps every precedence.
void check(const Graph& g, std::span<const Index> order);

// Layer by layer: as many strokes as possible climb from the last region of a layer to the first of the next (dynamic
// program over the layers); the regions between are taken nearest first.  Ties to the lower id.
Order layer_order(const Graph& g);

} // namespace filum::sequence
