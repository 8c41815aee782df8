// Orders of all regions: their cost, their validity, and the order by layers.
#pragma once

#include "sequence/graph.hpp"

namespace filum::sequence {

using Order = std::vector<Index>;

// Whether a stroke can continue from u to v, printed next.
bool continues(const Graph& g, Index u, Index v);

// Which cost comes first in jobs with several tools.
enum class Priority : std::uint8_t { strokes, tool_changes };

struct Cost {
    Index strokes = 0;
    Index changes = 0; // of the tool
    double travel = 0; // mm between centres of area, summed over the starts of strokes except the first
    friend bool operator==(const Cost&, const Cost&) = default;
    friend auto operator<=>(const Cost&, const Cost&) = default;
};
Cost cost(const Graph& g, std::span<const Index> order);
// Whether `a` is less than `b`, by strokes and tool changes in the order of their priority; travel does not count.
bool less(const Cost& a, const Cost& b, Priority first);

// Throws Error(failure, "internal error: ...") unless `order` contains every region once and keeps every precedence.
void check(const Graph& g, std::span<const Index> order);

// Layer by layer: as many strokes as possible climb from the last region of a layer to the first of the next (dynamic
// program over the layers); the regions in between follow by nearest neighbour. Ties: the lower id. With several tools
// a layer begins with one and ends with another, and the regions of a tool come together.
Order layer_order(const Graph& g);

} // namespace filum::sequence
