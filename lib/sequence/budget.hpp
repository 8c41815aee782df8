// How much work a search may do, as the user says it.
#pragma once

#include <cstdint>
#include <string>

namespace filum::sequence {

// Steps from "N", in millions, or "Ns", in seconds of a machine that takes kStepsPerSecond: a time is turned into
// steps, so that the result is the same on every machine.  0 .. 1e6 millions.
// Throws Error(usage) naming --budget if it is neither.
inline constexpr std::uint64_t kStepsPerSecond = 300'000'000;
std::uint64_t budget(const std::string& text);

} // namespace filum::sequence
