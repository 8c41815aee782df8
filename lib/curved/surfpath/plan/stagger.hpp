// Chooses how deep turns lie behind the rim, so that overlap and voids are small.
#pragma once

#include "surfpath/plan/plan.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::plan {

// The variants of one turn at different depths, the outermost first. Each includes the parts of its two rows that
// another variant would replace, so all begin and end at the same places.
using TurnVariants = std::vector<Stroke>;

// Per turn the index of the variant to lay, such that the sum of voids and overlap (mm2) is small. A deeper turn
// overlaps less, as its rows end sooner, but may leave a void that only it covered. Turns are chosen one after the
// other, given all others, until none changes; the sum never grows. `fixed` is the rest of the plan. Ties: the
// outermost variant.
std::vector<std::uint32_t> staggered(const Surface& surface, const Plan& fixed, std::span<const TurnVariants> turns,
                                     double width);

} // namespace filum::surfpath::plan
