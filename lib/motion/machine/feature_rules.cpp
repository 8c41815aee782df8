#include "machine/feature_rules.hpp"

#include "machine/read_features.hpp"

#include <algorithm>

namespace filum::machine {

void read_features(Document& doc, Controller controller, double most_acceleration, FeatureRules& rules) {
    if (controller != Controller::linuxcnc) {
        rules.set_acceleration =
            controller == Controller::klipper ? "SET_VELOCITY_LIMIT ACCEL={acceleration}" : "M204 P{acceleration}";
        rules.set_fan = "M106 S{fan_speed}";
    }
    doc.text("features.set_acceleration", rules.set_acceleration);
    doc.text("features.set_fan", rules.set_fan);
    const char* first_layer = "features.first_layer_acceleration";
    doc.number(first_layer, rules.first_layer_acceleration, {0, most_acceleration});
    rules.accelerates = rules.first_layer_acceleration > 0;
    if (rules.accelerates && rules.set_acceleration.empty())
        doc.fail(first_layer, "features.set_acceleration must say by which code, with {acceleration}");
    for (std::size_t f = 1; f < toolpath::kFeatures; ++f) {
        std::string name = toolpath::kFeatureNames[f];
        std::replace(name.begin(), name.end(), '-', '_');
        const std::string at = "features." + name + ".";
        FeatureRule& rule = rules.of[f];
        doc.number(at + "flow", rule.flow, {0, 10, true});
        doc.number(at + "acceleration", rule.acceleration, {0, most_acceleration, true});
        doc.number(at + "fan", rule.fan, {0, 1e4});
        rules.accelerates = rules.accelerates || rule.acceleration > 0;
        rules.blows = rules.blows || rule.fan >= 0;
        if (rule.acceleration > 0 && rules.set_acceleration.empty())
            doc.fail(at + "acceleration", "features.set_acceleration must say by which code, with {acceleration}");
        if (rule.fan >= 0 && rules.set_fan.empty())
            doc.fail(at + "fan", "features.set_fan must say by which code, with {fan_speed}");
    }
}

} // namespace filum::machine
