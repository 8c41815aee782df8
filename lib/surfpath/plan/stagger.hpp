// How deep turns lie behind the rim, so that they neither pile up there nor leave it bare.
#pragma once

#include "surfpath/plan/plan.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace filum::surfpath::plan {

// Ways to lay one turn, the outermost first: each with what the others replace of its two rows, so that all begin and
// end at the same places.
using Depths = std::vector<Stroke>;

// Per turn the way to lay it, such that what all leave bare and what they lay twice is small in sum, mm2: a turn that
// lies deeper lays less twice, as its rows end sooner, but may leave bare what only it covered.  One turn is chosen
// after the other, given the others, until none changes; the sum never grows.  `fixed` is what is laid besides.  Of
// equal ways the outermost.
std::vector<std::uint32_t> staggered(const Surface& surface, const Plan& fixed, std::span<const Depths> turns,
                                     double width);

} // namespace filum::surfpath::plan
