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

// The name of a bead for viewers. Joins have names of their own.
inline const char* type_name(toolpath::Role role, toolpath::Feature feature) {
    using toolpath::Role;
    if (role == Role::lift) return "Perimeter";
    if (role == Role::jog) return "Gap fill";
    if (role == Role::connector) return "Support material";
    return kTypeNames[static_cast<std::size_t>(feature)];
}

// True if that name alone identifies role and feature.
inline bool says_all(toolpath::Role role, toolpath::Feature feature) {
    return role == toolpath::Role::bead && feature_of_type(type_name(role, feature)) == feature;
}

} // namespace filum::machine
