// Orders unconnected lines by nearness.
#pragma once

#include "surfpath/plan/order.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

// The two ends of a line that can be passed in either direction.
struct EndPoints {
    Vec3 begin, end;
};

// Starts with the begin of the first line; next is always the line with the end nearest to where the last one ended,
// entered there. Ties: the first line, its begin. Takes about n log n.
std::vector<Visit> nearest_order(std::span<const EndPoints> ends);

} // namespace filum::surfpath::plan
