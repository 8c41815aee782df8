// The lines of a program between its moves: layers, pauses, labels of parts, progress.
#include "base/number.hpp"
#include "postproc/program.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace filum::postproc {

void Program::layer(const Step& step) {
    values_["layer"] = step.layer;
    layer_seconds_ = planned_->layer_seconds(layers_begun_++);
    values_["z"] = step.to.z;
    values_["height"] = step.height;
    if (profile_->format.viewer_comments) {
        comment("LAYER_CHANGE");
        comment("LAYER:" + std::to_string(step.layer));
        comment("Z:" + fixed_text(step.to.z, profile_->format.xyz_decimals));
        comment("HEIGHT:" + fixed_text(step.height, 3));
        height_ = step.height;
    }
    const bool upper = step.layer > 0;
    if (upper_ != upper) fan_ = -1; // the codes of the layers set it
    wait(step);
    const bool crossed = std::exchange(upper_, upper) != upper;
    if (layer_values(step) || crossed) code(upper ? profile_->templates.upper_layers : profile_->templates.first_layer);
    if (preset_ != nullptr)
        preset_code(preset_->before_layer(step.layer, step.to.z) + preset_->after_layer(step.layer, step.to.z));
    else
        code(profile_->templates.layer);
    layer_ = step;
    // Firmware that counts in single precision needs small numbers, so its extruder is reset.  An axis of a machine
    // tool is not reset, as a new offset could halt the stroke.
    if (counts() && !profile_->extrusion.relative && profile_->extrusion.letter == 'E') reset_extruder();
}

// Writes the pauses that are due before the layer.
void Program::wait(const Step& step) {
    const auto& all = planned_->pauses.all;
    waited_.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (waited_[i] != 0 || !all[i].before(step.layer, step.to.z, step.height)) continue;
        waited_[i] = 1;
        if (preset_ == nullptr)
            code(profile_->templates.pause);
        else if (all[i].what == machine::Pause::Kind::colour)
            preset_code(preset_->change_colour(step.layer, step.to.z));
        else
            preset_code(preset_->pause(step.layer, step.to.z));
    }
}

// Sets the values that hold from this layer on; true if one changed.
bool Program::layer_values(const Step& step) {
    machine::Values now;
    for (const LayerValue& v : planned_->by_layer) now.emplace(v.name, profile_->values.at(v.name));
    for (const LayerValue& v : planned_->by_layer)
        if (v.layer <= step.layer) now[v.name] = v.value;
    bool changed = false;
    for (const auto& [name, value] : now) changed = std::exchange(values_[name], value) != value || changed;
    if (changed) fan_ = -1; // the codes of the layers set it
    return changed;
}

// Writes the label of the part that the step leads to, if it is another part.
void Program::name_part(const Step& step) {
    const machine::Objects how = profile_->format.objects;
    if (how == machine::Objects::none || parts_.empty()) return;
    const auto to = static_cast<std::int64_t>(part_at(parts_, step.to.xy()));
    if (to == part_) return;
    if (part_ >= 0) line(end_part(how, parts_, static_cast<std::size_t>(part_)));
    part_ = to;
    const auto which = static_cast<std::size_t>(to);
    for (const auto& text : begin_part(how, parts_, which, std::exchange(named_[which], 1) == 0)) line(text);
}

void Program::tell_progress(const Step& step) {
    const double nominal = nominal_.add(step);
    if (profile_->templates.progress.empty() || !(planned_->seconds > 0)) return;
    const double share = std::min(1.0, planned_->timeline.seconds_at(nominal) / planned_->seconds);
    const auto percent = static_cast<std::int64_t>(100 * share);
    const auto minutes = static_cast<std::int64_t>(std::ceil(planned_->seconds * (1 - share) / 60));
    if (percent == percent_ && minutes == minutes_) return;
    percent_ = percent;
    minutes_ = minutes;
    values_["percent"] = static_cast<double>(percent);
    values_["minutes_left"] = static_cast<double>(minutes);
    code(profile_->templates.progress);
}

// Writes G-code of a slicer's profile; the feed after it is unknown.
void Program::preset_code(const std::string& text) {
    if (text.empty()) return;
    for (const char c : text) {
        if (c == '\n')
            end_line();
        else if (c != '\r')
            text_ += c;
    }
    f_ = -1;
}

} // namespace filum::postproc
