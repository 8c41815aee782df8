// What beads of one feature have of their own: [features.NAME] of a profile.
#pragma once

#include "toolpath/path.hpp"

#include <array>
#include <string>

namespace filum::machine {

struct FeatureRule {
    double flow = 1;         // factor on the material
    double acceleration = 0; // mm/s2; 0: motion.acceleration
    double fan = -1;         // as the machine counts it, above the first layer; -1: as elsewhere, values.fan
};

struct FeatureRules {
    std::array<FeatureRule, toolpath::kFeatures> of;
    // Codes with {acceleration} and {fan_speed}, where these change; needed if a rule has one.
    std::string set_acceleration, set_fan;
    bool accelerates = false, blows = false; // whether any rule has one

    const FeatureRule& operator[](toolpath::Feature f) const { return of[static_cast<std::size_t>(f)]; }
};

} // namespace filum::machine
