// Orders that climb columns as far as the precedence allows.
#pragma once

#include "sequence/order.hpp"

namespace filum::sequence {

// How to choose where the next stroke starts, among the regions that are ready.
enum class Choice : std::uint8_t { longest, lowest, latest };

// A stroke always goes on while it can (that costs nothing: whatever is ready now can only begin a stroke later). Where
// it ends, the next starts: first where it will reach the end of its column, then by `choice` (the longest stroke, the
// lowest start, the start that became ready last), then by lower number.  Of several ways up it takes the one with the
// longest way ahead.
Order climb(const Graph& g, Choice choice);

} // namespace filum::sequence
