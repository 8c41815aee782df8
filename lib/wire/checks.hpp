// What every message that arrives is checked for; private to lib/wire.
#pragma once

#include "base/error.hpp"

#include <cmath>
#include <string>

namespace filum::wire {

inline constexpr double kMaxCoordinate = 1e8; // mm; keeps every later product far from overflow

inline constexpr double kMaxBead = 1e4; // mm, of width and height: no machine lays one of 10 m

inline constexpr double kLongestSpan = 1e7; // mm, of the beads of a span: a layer of ten square metres

inline bool usable(double v) { return std::abs(v) <= kMaxCoordinate; } // false for nan, too

// Whether `v` is finite and not negative.
inline bool is_size(double v) { return v >= 0 && std::isfinite(v); }

// Throws Error(bad_input) naming the kind of frame and the fault.
[[noreturn]] inline void bad_frame(const std::string& kind, const std::string& why) {
    throw Error(Exit::bad_input, "cannot use a " + kind + " frame: " + why);
}

} // namespace filum::wire
