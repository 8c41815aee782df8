// The budget of a search as users write it.
#pragma once

#include <cstdint>
#include <string>

namespace filum::sequence {

// Steps from "N", in millions, or "Ns", in seconds of a machine that takes kStepsPerSecond steps per second: times are
// converted to steps, so that the result is the same on every machine. 0 to 1e6 millions.
// Throws Error(usage), naming --budget, for any other text.
inline constexpr std::uint64_t kStepsPerSecond = 300'000'000;
std::uint64_t budget(const std::string& text);

} // namespace filum::sequence
