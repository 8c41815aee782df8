#include "preset/program.hpp"

#include "preset/orca_code.hpp"
#include "preset/start_code.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace filum::preset {

namespace {

using macro::Value;
using macro::Variable;

// Adds a line end to a text that lacks one.
void end_line(std::string& text) {
    if (!text.empty() && text.back() != '\n') text += '\n';
}

Variable whole(double value) { return Variable::one(static_cast<std::int64_t>(std::llround(value))); }

} // namespace

Program::Program(const Preset& preset, Job job) : settings_(preset), job_(std::move(job)) {
    if (!preset.input.empty()) job_.input = preset.input;
    orca_ = preset.slicer == "orca" || preset.slicer == "bambu";
    heats_ = preset.slicer != "cura";
    const std::string word = settings_.text("gcode_flavor");
    flavor_ = flavor_of(word.empty() ? orca_ ? "marlin" : "reprap" : word);
    tool_ = job_.first_tool;
    scope_.find = [this](std::string_view name) -> const Variable* {
        if (const auto found = now_.find(name); found != now_.end()) return &found->second;
        return settings_.find(name);
    };
    scope_.numbers_hold = orca_;
    set_job_values(job_, orca_, settings_);
}

void Program::set(const std::string& name, double value) {
    const Variable* known = settings_.find(name);
    Variable out = known == nullptr ? whole(value) : *known;
    const std::size_t count = std::max<std::size_t>(1, out.items.size());
    out.items.assign(count, static_cast<std::int64_t>(std::llround(value)));
    out.written.clear();
    settings_.set(name, std::move(out));
}

std::string Program::code(const char* key, const std::string& text, std::uint32_t tool) {
    if (text.empty()) return "";
    auto found = read_.find(text);
    if (found == read_.end()) found = read_.emplace(text, macro::parsed(key, text)).first;
    scope_.extruder = tool;
    std::string out = macro::expand(found->second, scope_);
    end_line(out);
    return out;
}

// The first of these settings that is not empty, as slicers have several names for one setting.
std::string Program::code_of(std::initializer_list<const char*> names, std::uint32_t tool) const {
    for (const char* name : names)
        if (std::string text = settings_.text(name, tool); !text.empty()) return text;
    return "";
}

// The printer's start or end. OrcaSlicer and Bambu Studio have "machine_" before the name.
std::string Program::printer_code(const std::string& name, std::uint32_t tool) {
    const std::string of_orca = "machine_" + name;
    const char* key = orca_ || settings_.text(name).empty() ? of_orca.c_str() : name.c_str();
    return code(key, code_of({key}), tool);
}

std::string Program::filament_code(const char* key, std::uint32_t tool) {
    const bool start = std::string_view(key).starts_with("start");
    const std::string text = code_of({key, start ? "filament_start_gcode" : "filament_end_gcode"}, tool);
    now_["filament_extruder_id"] = whole(tool);
    return code(key, text, tool);
}

// The number of a tool in temperature commands; -1: no word for the tool.
int Program::tool_word(std::uint32_t tool) const {
    const bool several = job_.tools.back() > 0 && !settings_.flag("single_extruder_multi_material");
    return several || flavor_ == Flavor::reprapfirmware ? static_cast<int>(tool) : -1;
}

// Sets the values of the layer for macros.
void Program::place(std::uint32_t layer, double z) {
    highest_ = std::max(highest_, z);
    now_["layer_num"] = whole(layer);
    now_["layer_z"] = Variable::one(z);
    now_["max_layer_z"] = Variable::one(highest_);
}

std::string Program::first_bed_temperature(const std::string& start) {
    const char* name = orca_ ? "bed_temperature_initial_layer_single" : "first_layer_bed_temperature";
    bed_ = static_cast<int>(settings_.number(name, job_.first_tool));
    const TemperatureCommands set = temperature_commands(start, 140, 190, false);
    if (set.any) {
        if (!orca_ && set.celsius >= 0 && set.celsius < 1000) bed_ = set.celsius; // OrcaSlicer goes by its setting
        return "";
    }
    // Slicers take the bed to be at 0 degrees and write no command that would leave it there.
    return heats_ && bed_ != 0 ? bed_temperature(flavor_, bed_, true) : "";
}

std::string Program::temperatures(const std::string& start, bool wait) {
    if (!heats_) return "";
    if (temperature_commands(start, 104, 109, flavor_ == Flavor::reprapfirmware).any) return "";
    const char* name = orca_ ? "nozzle_temperature_initial_layer" : "first_layer_temperature";
    std::string out;
    for (const std::uint32_t tool : job_.tools) {
        if (settings_.flag("single_extruder_multi_material") && tool != job_.first_tool) continue;
        double celsius = settings_.number(name, tool);
        if (settings_.flag("ooze_prevention") && !settings_.flag("single_extruder_multi_material"))
            celsius += settings_.number("standby_temperature_delta");
        if (celsius > 0) out += nozzle_temperature(flavor_, static_cast<int>(celsius), wait, tool_word(tool));
    }
    return out;
}

std::string Program::start() {
    std::string out = machine_limits(settings_, flavor_);
    now_.clear();
    const std::string own = printer_code("start_gcode", job_.first_tool);
    out += orca_ ? around_orca_start(own) : around_start(own);
    if (job_.tools.back() > 0) return out + change_tool(job_.first_tool, 0, 0);
    out += filament_code("start_filament_gcode", job_.first_tool);
    return orca_ ? out + pressure_advance(settings_, flavor_, job_.first_tool) : out;
}

// The start code `own` with the commands before and after it, as PrusaSlicer writes them.
std::string Program::around_start(const std::string& own) {
    std::string out;
    if (!settings_.flag("cooling", tool_) || settings_.number("disable_fan_first_layers", tool_) > 0) out += "M107\n";
    out += first_bed_temperature(own);
    out += temperatures(own, false);
    out += ";TYPE:Custom\n" + own;
    out += temperatures(own, true);
    return out + preamble(flavor_, settings_.flag("use_relative_e_distances") && !settings_.flag("use_absolute_e"));
}

// The same as OrcaSlicer and Bambu Studio write them: Klipper's macros heat, and only printers of Bambu Lab wait for
// the nozzle after the start code.
std::string Program::around_orca_start(const std::string& own) {
    std::string out;
    if (settings_.flag("auxiliary_fan") && settings_.number("close_fan_the_first_x_layers", job_.first_tool) > 0)
        out += fans_off(settings_);
    if (flavor_ == Flavor::klipper)
        bed_ = 0; // not set by the slicer so far
    else
        out += first_bed_temperature(own) + temperatures(own, false);
    out += ";TYPE:Custom\n" + chamber(settings_, job_.tools, true) + own;
    if (of_bambu_lab(settings_)) out += temperatures(own, true);
    out += exhaust_fan(settings_, job_.tools, "during_print_exhaust_fan_speed");
    return out + preamble(flavor_, settings_.flag("use_relative_e_distances"));
}

std::string Program::change_tool(std::uint32_t to, std::uint32_t layer, double z) {
    const bool first = now_.empty();
    std::string out = first ? "" : filament_code("end_filament_gcode", tool_);
    place(layer, z);
    now_["previous_extruder"] = whole(first ? -1 : static_cast<double>(tool_));
    now_["next_extruder"] = whole(to);
    now_["toolchange_z"] = Variable::one(z);
    const std::string own = code("toolchange_gcode", code_of({"toolchange_gcode", "change_filament_gcode"}), to);
    out += own;
    if (!changes_tool(own, to)) {
        out += "T" + std::to_string(to) + "\n";
        out += reset_extruder(flavor_, settings_.flag("use_relative_e_distances"));
    }
    tool_ = to;
    settings_.set("current_extruder", whole(to));
    return out + filament_code("start_filament_gcode", to);
}

std::string Program::before_layer(std::uint32_t layer, double z) {
    place(layer, z);
    const char* key = orca_ ? "before_layer_change_gcode" : "before_layer_gcode";
    return code(key, code_of({key}), tool_);
}

std::string Program::after_layer(std::uint32_t layer, double z) {
    place(layer, z);
    const char* key = orca_ ? "layer_change_gcode" : "layer_gcode";
    std::string out;
    if (orca_ && !of_bambu_lab(settings_)) out += code("time_lapse_gcode", code_of({"time_lapse_gcode"}), tool_);
    out += code(key, code_of({key}), tool_);
    return layer > 0 && !std::exchange(warm_, true) ? out + later_temperatures() : out;
}

// Commands after the first layer, for temperatures that differ from those of the first layer.
std::string Program::later_temperatures() {
    const char* later = orca_ ? "nozzle_temperature" : "temperature";
    const char* first = orca_ ? "nozzle_temperature_initial_layer" : "first_layer_temperature";
    std::string out;
    for (const std::uint32_t tool : job_.tools) {
        if (settings_.flag("single_extruder_multi_material") && tool != tool_) continue;
        const double celsius = settings_.number(later, tool);
        if (celsius > 0 && celsius != settings_.number(first, tool))
            out += nozzle_temperature(flavor_, static_cast<int>(celsius), false, tool_word(tool));
    }
    const int bed =
        static_cast<int>(settings_.number(orca_ ? "bed_temperature_single" : "bed_temperature", job_.first_tool));
    if (bed != bed_) out += bed_temperature(flavor_, bed, false);
    bed_ = bed;
    return out;
}

std::string Program::pause(std::uint32_t layer, double z) {
    place(layer, z);
    const char* key = orca_ ? "machine_pause_gcode" : "pause_print_gcode";
    std::string text = code_of({key});
    if (text.empty()) text = "M601";
    return code(key, text, tool_);
}

std::string Program::change_colour(std::uint32_t layer, double z) {
    place(layer, z);
    const char* key = "color_change_gcode";
    std::string text = code_of({key});
    if (text.empty()) text = "M600";
    return ";COLOR_CHANGE,T" + std::to_string(tool_) + "\n" + code(key, text, tool_);
}

// The lift of the nozzle at a retraction at height z, mm.
double Program::last_lift(double z) const {
    const bool retracts = settings_.number("retract_length", tool_) > 0 || settings_.flag("use_firmware_retraction");
    const double above = settings_.number("retract_lift_above", tool_),
                 below = settings_.number("retract_lift_below", tool_);
    return retracts && z >= above && (below <= 0 || z <= below) ? settings_.number("retract_lift", tool_) : 0;
}

std::string Program::end(std::uint32_t layer, double z) {
    place(layer, z);
    // PrusaSlicer reports the height of the nozzle after its last retraction.
    if (!orca_) now_["layer_z"] = Variable::one(z + last_lift(z));
    std::string out = (orca_ ? orca_end(settings_) : "") + ";TYPE:Custom\n";
    const std::size_t filaments =
        std::max(settings_.texts("end_filament_gcode").size(), settings_.texts("filament_end_gcode").size());
    if (settings_.flag("single_extruder_multi_material") || orca_)
        out += filament_code("end_filament_gcode", tool_);
    else
        for (std::uint32_t tool = 0; tool < filaments; ++tool) out += filament_code("end_filament_gcode", tool);
    out += printer_code("end_gcode", tool_);
    if (flavor_ == Flavor::machinekit) out += "M2 ; end of program\n";
    if (orca_)
        out += chamber(settings_, job_.tools, false) +
               exhaust_fan(settings_, job_.tools, "complete_print_exhaust_fan_speed");
    return out;
}

} // namespace filum::preset
