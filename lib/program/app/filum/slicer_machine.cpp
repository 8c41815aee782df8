#include "app/filum/slicer_machine.hpp"

#include "app/filum/cura_printer.hpp"
#include "app/filum/cura_stack.hpp"
#include "base/error.hpp"
#include "base/number.hpp"
#include "base/shell.hpp"
#include "machine/profile.hpp"
#include "preset/program.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

namespace filum::app::filum {

namespace {

using preset::Settings;

std::string word_of(Slicer slicer) {
    constexpr std::array kWords{"", "slic3r", "prusa", "super", "orca", "bambu", "cura"};
    return kWords[static_cast<std::size_t>(slicer)];
}

bool of_orca(Slicer slicer) { return slicer == Slicer::orca || slicer == Slicer::bambu; }

preset::Preset preset_of(const SlicerFile& file, const std::string& input) {
    preset::Preset out;
    out.slicer = word_of(file.slicer);
    out.input = input.empty() || input == "-" ? "" : std::filesystem::path(input).stem().string();
    // Texts from JSON hold line ends as such; lines "name = value" hold them as the letters \n.
    const bool json = of_orca(file.slicer) && std::ranges::any_of(file.settings, [](const SlicerSetting& s) {
                          return s.value.find('\n') != std::string::npos;
                      });
    for (const SlicerSetting& s : file.settings)
        out.settings[s.key] = json ? preset::values_of_json(s.key, s.value) : preset::values_of_line(s.key, s.value);
    return out;
}

// The text as a string of TOML.  Carriage returns are dropped.  Other control characters become blanks, except line
// ends and tabs, since no program may hold them.
std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '\r') continue;
        if (c == '"' || c == '\\') out += '\\';
        if (c == '\n')
            out += "\\n";
        else if (c == '\t')
            out += "\\t";
        else
            out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
    return out + "\"";
}

std::string pair(double a, double b) { return "[" + shortest_text(a) + ", " + shortest_text(b) + "]"; }

struct Extent {
    double x_min = 0, x_max = 200, y_min = 0, y_max = 200;
};

Extent bed_of(const Settings& settings, bool orca) {
    Extent out;
    const std::vector<geom::Vec2> corners = preset::corners(settings.texts(orca ? "printable_area" : "bed_shape"));
    if (!corners.empty()) out = {corners[0].x, corners[0].x, corners[0].y, corners[0].y};
    for (const geom::Vec2& p : corners)
        out = {std::min(out.x_min, p.x), std::max(out.x_max, p.x), std::min(out.y_min, p.y), std::max(out.y_max, p.y)};
    if (!(out.x_max > out.x_min) || !(out.y_max > out.y_min))
        throw Error(Exit::bad_input, "cannot use the shape of the bed: its corners enclose no area");
    return out;
}

// The name with letters, digits, '.', '_' and '-', at most 60 characters.  Runs of other characters become one '-'.
std::string plain(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool fits = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '.' ||
                          c == '_' || c == '-';
        if (fits || (!out.empty() && out.back() != '-')) out += fits ? c : '-';
    }
    return out.substr(0, 60);
}

std::string name_of_printer(const Settings& settings) {
    for (const char* key : {"printer_model", "printer_settings_id", "printer_variant"})
        if (std::string name = plain(settings.text(key)); !name.empty()) return name;
    return "slicer-printer";
}

const char* controller(preset::Flavor flavor) {
    return flavor == preset::Flavor::klipper          ? "klipper"
           : flavor == preset::Flavor::reprapfirmware ? "reprapfirmware"
                                                      : "marlin";
}

std::string extrusion_text(const Settings& settings, preset::Flavor flavor) {
    const bool axis = preset::extruder_letter(flavor) != 'E';
    const bool relative = !axis && settings.flag("use_relative_e_distances");
    std::string out = "[extrusion]\nkind = ";
    out += settings.flag("use_volumetric_e") ? "\"volume\"\n" : "\"filament\"\n";
    out += "diameter = " + shortest_text(settings.number("filament_diameter", 0, 1.75)) + "\n";
    out += "letter = " + quoted(std::string(1, preset::extruder_letter(flavor))) + "\n";
    out += std::string("mode = \"") + (relative ? "relative" : "absolute") + "\"\n\n";
    return out;
}

// The sections [motion] and [feeds] of the profile, with the limits that the slicer knows.
std::string motion_text(const Settings& settings, preset::Flavor flavor) {
    std::string out = std::string("[motion]\ncontroller = \"") + controller(flavor) + "\"\n";
    const auto add = [&](const char* key, double value) {
        if (value > 0) out += std::string(key) + " = " + shortest_text(value) + "\n";
    };
    const auto fastest = [&](const std::string& axis) { // OrcaSlicer's key, else PrusaSlicer's
        const std::string name =
            settings.find("machine_max_speed_" + axis) ? "machine_max_speed_" : "machine_max_feedrate_";
        return settings.number(name + axis);
    };
    const machine::Feeds usual;
    const double most = std::max(fastest("x"), fastest("y")), most_z = fastest("z");
    add("max_speed", most);
    add("max_speed_z", most_z);
    out += "\n[feeds]\n";
    if (most > 0 && usual.travel > most) add("travel", most);
    for (const auto& [key, feed] :
         {std::pair("bead", usual.bead), std::pair("first_layer", usual.first_layer), std::pair("lift", usual.lift),
          std::pair("jog", usual.jog), std::pair("connector", usual.connector)})
        if (most > 0 && feed > most) add(key, most);
    if (most_z > 0 && usual.z > most_z) add("z", most_z);
    return out + "\n";
}

std::string settings_text(const preset::Preset& from) {
    std::string out =
        "[preset]\nslicer = " + quoted(from.slicer) + "\ninput = " + quoted(from.input) + "\n\n[preset.settings]\n";
    for (const auto& [key, values] : from.settings) {
        const bool list = values.size() != 1;
        out += (preset::key_of(key) != nullptr ? key : quoted(key)) + " = ";
        if (list) out += "[";
        for (std::size_t i = 0; i < values.size(); ++i) out += (i > 0 ? ", " : "") + quoted(values[i]);
        out += list ? "]\n" : "\n";
    }
    return out;
}

// Expands the printer's G-code for a job without a part, so that a fault is found before anything is computed.
void try_codes(const preset::Preset& from) {
    preset::Program program(from, {});
    (void)program.start();
    for (const std::uint32_t layer : {0U, 1U}) {
        (void)program.before_layer(layer, 0.2);
        (void)program.after_layer(layer, 0.2);
    }
    (void)program.end(1, 0.4);
}

} // namespace

std::string machine_of(const SlicerFile& all, const std::string& input) {
    const SlicerFile file = all.slicer == Slicer::cura ? cura_printer(all) : all;
    if (!file.has("start_gcode") && !file.has("machine_start_gcode") && !file.has("bed_shape") &&
        !file.has("printable_area"))
        return "";
    const preset::Preset preset = preset_of(file, input);
    const Settings settings(preset);
    const bool orca = of_orca(file.slicer);
    try_codes(preset);
    const preset::Flavor flavor = preset::Program(preset, {}).flavor();
    const Extent bed = bed_of(settings, orca);
    const double height = settings.number(orca ? "printable_height" : "max_print_height");
    const double nozzle = settings.number("nozzle_diameter", 0, 0.4);
    std::string out = "name = " + quoted(name_of_printer(settings)) + "\n";
    out += "about = " + quoted(std::string("made of settings of ") + name_of(file.slicer)) + "\n\n";
    out += "[bed]\nx = " + pair(bed.x_min, bed.x_max) + "\ny = " + pair(bed.y_min, bed.y_max) +
           "\nz = " + pair(0, height > 0 ? height : 200) + "\n\n";
    out += "[head]\nflat_radius = " + shortest_text(nozzle / 2) + "\n\n";
    out += extrusion_text(settings, flavor);
    out += "[limits]\nsection = " + shortest_text(4 * nozzle * nozzle) + "\n\n";
    if (settings.flag("use_firmware_retraction"))
        out += "[travel]\nretract_codes = \"G10 ; retract\"\nprime_codes = \"G11 ; unretract\"\n\n";
    out += motion_text(settings, flavor);
    out += "[format]\ntravel_code = \"G1\"\n\n";
    out += "[values]\nfan = 255\n\n[templates]\nupper_layers = \"M106 S{fan}\"\nprogress = \"M73 P{percent} "
           "R{minutes_left}\"\n\n";
    return out + settings_text(preset);
}

SlicerMachine::SlicerMachine(std::vector<SlicerFile> files, std::vector<std::string> sources)
    : sources_(std::move(sources)) {
    for (SlicerFile& file : files) put_over(file_, std::move(file));
    if (file_.slicer == Slicer::cura) calculate_formulas(file_);
    text_ = machine_of(file_, "");
    if (text_.empty()) return;
    path_ = folder_.file("slicer-machine.toml");
    write(text_);
}

void SlicerMachine::name_input(const std::string& input) const { write(machine_of(file_, input)); }

void SlicerMachine::write(const std::string& text) const {
    std::ofstream out(path_, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw Error(Exit::io, "cannot write '" + path_ + "': " + std::strerror(errno));
}

std::string SlicerMachine::command() const {
    std::string out = "filum settings --machine";
    for (const std::string& source : sources_) out += " " + shell_word(source);
    return out + " > " + kShownName + "\n";
}

} // namespace filum::app::filum
