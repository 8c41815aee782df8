// The number of no node, end, ring or sample.  Private to lib/fill.
#pragma once

#include <cstdint>
#include <limits>

namespace filum::fill {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

} // namespace filum::fill
