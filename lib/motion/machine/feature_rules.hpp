// Flow, acceleration and fan of beads by feature: [features.NAME] of a profile.
#pragma once

#include "toolpath/path.hpp"

#include <array>
#include <string>

namespace filum::machine {

struct FeatureRule {
    double flow = 1;         // factor on the material
    double acceleration = 0; // mm/s2; 0: motion.acceleration
    double fan = -1;         // fan speed above the first layer, in the machine's unit; -1: as elsewhere
};

struct FeatureRules {
    std::array<FeatureRule, toolpath::kFeatures> of;
    // Codes with {acceleration} and {fan_speed} that change them; required if a rule has such a value.
    std::string set_acceleration, set_fan;
    bool accelerates = false, blows = false; // a rule has an acceleration, a fan speed
    double first_layer_acceleration = 0;     // mm/s2, of all beads of the first layer; 0: as above it

    const FeatureRule& operator[](toolpath::Feature f) const { return of[static_cast<std::size_t>(f)]; }
    // The acceleration of a bead, mm/s2; 0: motion.acceleration.
    [[nodiscard]] double acceleration(toolpath::Feature f, std::uint32_t layer) const {
        return layer == 0 && first_layer_acceleration > 0 ? first_layer_acceleration : (*this)[f].acceleration;
    }
};

} // namespace filum::machine
