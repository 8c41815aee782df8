// Checks that every message from a stream must pass; private to lib/program/wire.
#pragma once

#include "base/error.hpp"

#include <cmath>
#include <string>

namespace filum::wire {

inline constexpr double kMaxCoordinate = 1e8; // mm; keeps later products far from overflow

inline constexpr double kMaxBead = 1e4; // mm, largest width and height of a bead: no machine deposits a bead of 10 m

// Largest length of the beads in a span, mm: as on a layer of ten square metres.
inline constexpr double kLongestSpan = 1e7;

inline bool usable(double v) { return std::abs(v) <= kMaxCoordinate; } // false for nan

// True if `v` is finite and not negative.
inline bool is_size(double v) { return v >= 0 && std::isfinite(v); }

// Throws Error(bad_input) naming the kind of frame and the fault.
[[noreturn]] inline void bad_frame(const std::string& kind, const std::string& why) {
    throw Error(Exit::bad_input, "cannot use a " + kind + " frame: " + why);
}

// Throws Error(bad_input) unless the height of a layer is positive and its top is a number.
inline void check_height(double z, double height, const char* what) {
    if (!usable(z) || !usable(height) || height <= 0) bad_frame(what, "its height is not positive");
}

} // namespace filum::wire
