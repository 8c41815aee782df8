// The features of beads, and the share of their width that lies over air. Private to lib/program/wire: `c` is
// a message of protobuf, which installed headers do not name.
#pragma once

#include "toolpath/path.hpp"
#include "wire/checks.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace filum::wire {

// Throws Error(bad_input) for an unknown number.
inline toolpath::Feature feature(int value, const char* what) {
    if (value < 0 || static_cast<std::size_t>(value) >= toolpath::kFeatures) bad_frame(what, "unknown feature");
    return static_cast<toolpath::Feature>(value);
}

// Throws Error(bad_input) for more than 100.
inline std::uint8_t percent_over_air(std::uint32_t value, const char* what) {
    if (value > 100) bad_frame(what, "more than 100 % of a bead's width is over air");
    return static_cast<std::uint8_t>(value);
}

inline std::size_t segments(const auto& c, std::size_t points) { return points - (c.closed() ? 0 : 1); }

// The features of a curve, one for all segments or one for each.
inline std::vector<toolpath::Feature> features(const auto& c, std::size_t points) {
    const auto n = static_cast<std::size_t>(c.feature_size());
    if (n > 1 && n != segments(c, points))
        bad_frame("paths", "its features must be none, one for all, or one per segment");
    std::vector<toolpath::Feature> out;
    out.reserve(n);
    for (const int value : c.feature()) out.push_back(feature(value, "paths"));
    return out;
}

// The shares over air of a curve, one for each segment or none.
inline std::vector<std::uint8_t> over_air(const auto& c, std::size_t points) {
    const auto n = static_cast<std::size_t>(c.over_air_size());
    if (n > 0 && n != segments(c, points)) bad_frame("paths", "its shares over air must be none, or one per segment");
    std::vector<std::uint8_t> out;
    out.reserve(n);
    for (const std::uint32_t value : c.over_air()) out.push_back(percent_over_air(value, "paths"));
    return out;
}

} // namespace filum::wire
