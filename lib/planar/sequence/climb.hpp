// Greedy orders that climb columns as far as precedence allows.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

// How the next stroke's start is chosen among the ready regions.
enum class StartRule : std::uint8_t { longest, lowest, latest };

// When the next stroke keeps the tool of the last one: never for its own sake, if its stroke reaches the end of its
// column, or whenever a region of that tool is ready.
enum class KeepTool : std::uint8_t { never, to_the_end, always };

// A stroke continues as long as it can, which costs nothing, because a region that is ready now can only begin a later
// stroke. The next start is one whose stroke reaches the end of its column; otherwise by `rule` (the longest stroke,
// the lowest start, the start that became ready last); ties: the lower number. Of several links up a stroke takes the
// one with the longest path ahead.
Order climb(const Graph& g, StartRule rule, KeepTool keep = KeepTool::never);

} // namespace filum::sequence
