// In which order to lay what does not hang together.
#pragma once

#include "surfpath/plan/order.hpp"
#include "surfpath/plan/plan.hpp"

namespace filum::surfpath::plan {

// Where something begins and where it ends; it may be laid either way round.
struct Ends {
    Vec3 begin, end;
};

// From the first on always the one next whose nearer end is nearest to where the last one ended; of equals the first,
// from its begin on.  Takes about n log n.
std::vector<Visit> in_turn(std::span<const Ends> ends);

} // namespace filum::surfpath::plan
