// Acceleration and fan of beads.
#include "postproc/program.hpp"

#include <cmath>

namespace filum::postproc {

// Writes the codes for the feature's acceleration and fan where these change.
void Program::feature_codes(const Step& step) {
    const machine::FeatureRules& rules = profile_->features;
    const machine::FeatureRule& rule = rules[step.feature];
    const auto set = [&](double& now, double wanted, const char* name, const std::string& codes) {
        if (now == wanted) return;
        values_[name] = now = wanted;
        code(codes);
    };
    const double usual = profile_->motion.acceleration;
    const double own = rules.acceleration(step.feature, step.layer);
    if (rules.accelerates) set(acceleration_, own > 0 ? own : usual, "acceleration", rules.set_acceleration);
    const machine::Cooling& cooling = profile_->cooling;
    if (cooling.active() && rule.fan < 0) {
        const bool hangs = step.over_air > 0 && toolpath::fills(step.role);
        const double speed = step.feature == Feature::bridge
                                 ? cooling.bridge_speed(step.layer, layer_seconds_)
                                 : cooling.raised(step.layer, layer_seconds_,
                                                  hangs ? profile_->overhang.fan(step.over_air / 100.0) : -1);
        set(fan_, std::round(speed * 10) / 10, "fan_speed", rules.set_fan);
        return;
    }
    if (!rules.blows || step.layer == 0) return;
    const auto fan = values_.find("fan");
    const double blown = fan == values_.end() ? 0 : fan->second;
    if (fan_ < 0) fan_ = blown;
    set(fan_, rule.fan >= 0 ? rule.fan : blown, "fan_speed", rules.set_fan);
}

} // namespace filum::postproc
