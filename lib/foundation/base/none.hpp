// The index that stands for "none": no node, end, ring or sample.
#pragma once

#include <cstdint>
#include <limits>

namespace filum {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

} // namespace filum
