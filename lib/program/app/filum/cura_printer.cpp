#include "app/filum/cura_printer.hpp"

#include "app/filum/cura_stack.hpp"
#include "app/filum/slicer_table.hpp"
#include "app/filum/slicer_text.hpp"
#include "base/error.hpp"
#include "base/number.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <utility>

namespace filum::app::filum {

namespace {

// Cura's names for values that Filum keeps under another name, and what stands for them in macros.
constexpr std::pair<std::string_view, std::string_view> kCuraNames[] = {
    {"material_print_temperature", "temperature[0]"},
    {"material_print_temperature_layer_0", "first_layer_temperature[0]"},
    {"default_material_print_temperature", "temperature[0]"},
    {"material_bed_temperature", "bed_temperature[0]"},
    {"material_bed_temperature_layer_0", "first_layer_bed_temperature[0]"},
    {"default_material_bed_temperature", "bed_temperature[0]"},
    {"material_initial_print_temperature", "first_layer_temperature[0]"},
    {"material_final_print_temperature", "temperature[0]"},
    {"print_temperature", "temperature[0]"},
    {"print_bed_temperature", "bed_temperature[0]"},
    {"travel_speed", "speed_travel"},
    {"initial_extruder_nr", "initial_tool"},
    {"jobname", "input_filename_base"},
    {"date", "zdigits(day, 2)}-{zdigits(month, 2)}-{year"},
    {"time", "zdigits(hour, 2)}:{zdigits(minute, 2)}:{zdigits(second, 2)"},
    {"elif", "elsif"}};

// A text as the value of one line "name = value".
std::string as_one_line(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '\\') out += '\\';
        if (c == '\n')
            out += "\\n";
        else if (c != '\r')
            out += c;
    }
    return out;
}

constexpr double kFastest = 1e5; // mm/s that a machine's profile takes

bool is_name_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// Converts G-code of Cura to macros.
class CuraCode {
  public:
    explicit CuraCode(const SlicerFile& settings) : settings_(settings) {}

    [[nodiscard]] std::string macros(std::string_view code) const {
        std::string out;
        bool comment = false;
        while (!code.empty()) {
            const char c = code.front();
            if (c == ';') comment = true;
            if (c == '\n') comment = false;
            const std::size_t end = c == '{' ? code.substr(0, code.find('\n')).find('}') : std::string_view::npos;
            if (end != std::string_view::npos) {
                out += expression(code.substr(1, end - 1), comment);
                code.remove_prefix(end + 1);
                continue;
            }
            if (c == '[' || c == '{') // such a bracket is text in Cura, and begins a macro of PrusaSlicer
                out += std::string("{\"") + c + "\"}";
            else
                out += c;
            code.remove_prefix(1);
        }
        return out;
    }

    // Whether the code names one of the values.
    static bool names(const std::string& code, std::initializer_list<const char*> values) {
        return std::ranges::any_of(values, [&](const char* value) {
            for (std::size_t at = code.find(value); at != std::string::npos; at = code.find(value, at + 1)) {
                const std::size_t open = code.rfind('{', at), behind = at + std::string_view(value).size();
                if (open == std::string::npos || code.substr(open, at - open).find('}') != std::string::npos) continue;
                if (!is_name_letter(code[at - 1]) && (behind == code.size() || !is_name_letter(code[behind])))
                    return true;
            }
            return false;
        });
    }

  private:
    // What stands between braces.  The number of an extruder behind a name is dropped, since one extruder prints.
    [[nodiscard]] std::string expression(std::string_view inner, bool comment) const {
        const std::string name = trimmed(std::string(inner.substr(0, inner.find(','))));
        const bool lone = !name.empty() && std::ranges::all_of(name, is_name_letter);
        constexpr std::string_view kWords[] = {"else", "endif"};
        if (lone && std::ranges::find(kWords, name) != std::end(kWords)) return "{" + name + "}";
        if (lone && !known(name) && comment) return "{\"{\"}" + std::string(inner) + "}";
        return "{" + renamed(lone ? name : std::string(inner)) + "}";
    }
    [[nodiscard]] bool known(const std::string& name) const {
        return std::ranges::any_of(kCuraNames, [&](const auto& pair) { return pair.first == name; }) ||
               settings_.has(name);
    }
    static std::string renamed(const std::string& expression) {
        std::string out;
        for (std::size_t at = 0; at < expression.size();) {
            std::size_t end = at;
            while (end < expression.size() && is_name_letter(expression[end])) ++end;
            const std::string_view word = std::string_view(expression).substr(at, std::max(end, at + 1) - at);
            const auto* const found = std::ranges::find(kCuraNames, word, [](const auto& pair) { return pair.first; });
            out += found == std::end(kCuraNames) ? word : found->second;
            at += word.size();
        }
        return out;
    }

    const SlicerFile& settings_;
};

double number_or_zero(const CuraStack& cura, const std::string& key) { return cura.number(key).value_or(0); }

std::string cura_flavour(const CuraStack& cura) {
    const std::string name = trimmed(cura.text("machine_gcode_flavor"));
    constexpr std::pair<std::string_view, const char*> kFlavours[] = {{"RepRap (Marlin/Sprinter)", "marlin"},
                                                                      {"Marlin", "marlin"},
                                                                      {"Cheetah", "marlin"},
                                                                      {"RepRap (Volumetric)", "marlin"},
                                                                      {"RepRap (RepRap)", "reprapfirmware"},
                                                                      {"Repetier", "repetier"}};
    for (const auto& [theirs, ours] : kFlavours)
        if (name == theirs) return ours;
    throw Error(Exit::bad_input, "cannot use machine_gcode_flavor '" + name +
                                     "': Filum writes no programs for it; print with --machine NAME");
}

// The codes with which Cura heats before a start that names no temperature itself.
std::string cura_heating(const std::string& start, bool bed) {
    std::string out;
    if (bed && !CuraCode::names(start, {"material_bed_temperature", "material_bed_temperature_layer_0"}))
        out += "{if first_layer_bed_temperature[0] > 0}M140 S{first_layer_bed_temperature[0]}\nM190 "
               "S{first_layer_bed_temperature[0]}\n{endif}";
    if (!CuraCode::names(start, {"material_print_temperature", "material_print_temperature_layer_0",
                                 "default_material_print_temperature", "material_initial_print_temperature",
                                 "material_final_print_temperature", "material_standby_temperature"}))
        out += "M104 S{first_layer_temperature[0]}\nM109 S{first_layer_temperature[0]}\n";
    return out;
}

std::string cura_corners(const CuraStack& cura) {
    const double width = number_or_zero(cura, "machine_width"), depth = number_or_zero(cura, "machine_depth");
    const bool centre = cura.text("machine_center_is_zero") == "1";
    const double x = centre ? -width / 2 : 0, y = centre ? -depth / 2 : 0;
    const auto corner = [&](double dx, double dy) { return shortest_text(x + dx) + "x" + shortest_text(y + dy); };
    return corner(0, 0) + "," + corner(width, 0) + "," + corner(width, depth) + "," + corner(0, depth);
}

// Keys of PrusaSlicer whose number is that of a key of Cura.
constexpr std::pair<const char*, const char*> kNumbers[] = {
    {"max_print_height", "machine_height"},
    {"nozzle_diameter", "machine_nozzle_size"},
    {"layer_height", "layer_height"},
    {"first_layer_height", "layer_height_0"},
    {"temperature", "material_print_temperature"},
    {"first_layer_temperature", "material_print_temperature_layer_0"},
    {"bed_temperature", "material_bed_temperature"},
    {"first_layer_bed_temperature", "material_bed_temperature_layer_0"}};

} // namespace

SlicerFile cura_printer(const SlicerFile& file) {
    SlicerFile out{.slicer = Slicer::cura, .settings = {}, .remarks = {}};
    if (!file.has("machine_start_gcode") && !file.has("machine_width")) return out;
    const CuraStack cura(file);
    const auto put = [&](const char* key, std::string value) { out.settings.push_back({key, std::move(value)}); };
    const auto number = [&](const char* key, const char* of) { put(key, shortest_text(number_or_zero(cura, of))); };
    for (const preset::SettingRow& row : preset::setting_rows()) { // names for macros
        if (row.slicers != "cura" || row.key.ends_with("gcode") || preset::key_of(row.key) != nullptr) continue;
        const std::string text = cura.text(std::string(row.key));
        if (!text.empty()) out.settings.push_back({std::string(row.key), as_one_line(text)});
    }
    const std::string start = cura.text("machine_start_gcode"), end = cura.text("machine_end_gcode");
    const std::string heat = cura_heating(start, cura.text("machine_heated_bed") == "1");
    const SlicerFile known = out;
    const CuraCode code(known);
    put("start_gcode", as_one_line(heat + code.macros(start)));
    put("end_gcode", as_one_line(code.macros(end)));
    put("printer_model", as_one_line(cura.text("machine_name")));
    put("bed_shape", cura_corners(cura));
    put("gcode_flavor", cura_flavour(cura));
    put("use_relative_e_distances", cura.text("relative_extrusion") == "1" ? "1" : "0");
    put("use_volumetric_e", trimmed(cura.text("machine_gcode_flavor")) == "RepRap (Volumetric)" ? "1" : "0");
    put("use_firmware_retraction", cura.text("machine_firmware_retract") == "1" ? "1" : "0");
    put("machine_limits_usage", "time_estimate_only");
    for (const auto& [ours, theirs] : kNumbers) number(ours, theirs);
    if (file.has("material_diameter")) number("filament_diameter", "material_diameter");
    for (const char* axis : {"x", "y", "z"}) {
        const std::string key = std::string("machine_max_feedrate_") + axis;
        // Cura has the speed of light for no limit.
        if (const double mm_s = number_or_zero(cura, key); mm_s > 0 && mm_s < kFastest)
            put(key.c_str(), shortest_text(mm_s));
    }
    return out;
}

} // namespace filum::app::filum
