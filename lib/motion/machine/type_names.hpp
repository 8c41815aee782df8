// The names of beads in comments of programs.  They are those of PrusaSlicer, so that viewers show their colours.
#pragma once

#include "toolpath/path.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace filum::machine {

// By toolpath::Feature.
inline constexpr std::array<const char*, toolpath::kFeatures> kTypeNames{
    "Solid infill",    "External perimeter", "Perimeter",
    "Internal infill", "Solid infill",       "Top solid infill",
    "Solid infill",    "Bridge infill",      "Gap fill",
    "Ironing",         "Support material",   "Support material interface",
    "Skirt/Brim",      "Wipe tower"};

// The first feature with that name, as several share "Solid infill"; nullopt if there is none.
inline std::optional<toolpath::Feature> feature_of_type(std::string_view name) {
    for (std::size_t i = 0; i < kTypeNames.size(); ++i)
        if (name == kTypeNames[i]) return static_cast<toolpath::Feature>(i);
    return std::nullopt;
}

} // namespace filum::machine
