#include "preset/start_code.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace filum::preset {

namespace {

std::string_view without_blanks(std::string_view text) {
    const auto from = text.find_first_not_of(" \t");
    return from == std::string_view::npos ? std::string_view{} : text.substr(from);
}

// Takes a whole number off the beginning of a text.  False if there is none.
bool take_number(std::string_view& text, int& out) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error != std::errc()) return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

std::string with_two_decimals(double value) {
    std::array<char, 512> out{};
    std::snprintf(out.data(), out.size(), "%.2f", value);
    return out.data();
}

template <class Use>
void each_line(std::string_view text, Use use) {
    while (!text.empty()) {
        const auto end = std::min(text.find_first_of("\r\n"), text.size());
        use(without_blanks(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

} // namespace

TemperatureCommands temperature_commands(std::string_view text, int set, int set_and_wait, bool g10) {
    TemperatureCommands out;
    each_line(text, [&](std::string_view line) {
        if (line.empty() || (line[0] != 'M' && !(line[0] == 'G' && g10))) return;
        const bool of_tool = line[0] == 'G';
        line.remove_prefix(1);
        int number = 0;
        if (!take_number(line, number)) return;
        if (of_tool ? number != 10 : number != set && number != set_and_wait) return;
        if (!of_tool) out.any = true;
        line = without_blanks(line.substr(0, line.find(';')));
        while (!line.empty()) {
            if (line[0] == 'S') {
                line = without_blanks(line.substr(1));
                if (take_number(line, number)) {
                    out.celsius = number;
                    out.any = true; // G10 without S sets other things
                }
            }
            const auto end = line.find_first_of(" \t");
            line = end == std::string_view::npos ? std::string_view{} : without_blanks(line.substr(end));
        }
    });
    return out;
}

bool changes_tool(std::string_view text, std::uint32_t tool) {
    bool out = false;
    each_line(text, [&](std::string_view line) {
        if (line.empty() || line[0] != 'T') return;
        line.remove_prefix(1);
        int number = 0;
        out = out || (take_number(line, number) && static_cast<std::uint32_t>(number) == tool);
    });
    return out;
}

std::string machine_limits(const Settings& settings, Flavor flavor) {
    const bool rrf = flavor == Flavor::reprapfirmware;
    if (!rrf && flavor != Flavor::marlin && flavor != Flavor::marlin2) return "";
    // OrcaSlicer and Bambu Studio have their own name for the speeds. They emit the limits unless a setting forbids it.
    const bool orca = settings.find("machine_max_speed_x") != nullptr;
    const bool told = settings.find("emit_machine_limits_to_gcode") != nullptr;
    const bool asked = told   ? settings.flag("emit_machine_limits_to_gcode")
                       : orca ? true
                              : settings.text("machine_limits_usage") == "emit_to_gcode";
    if (!asked) return "";
    const auto value = [&](std::string name) {
        if (orca && name.starts_with("feedrate")) name.replace(0, 8, "speed");
        return settings.number("machine_max_" + name);
    };
    const auto whole = [](double v) { return std::to_string(static_cast<long long>(std::floor(v + 0.5))); };
    const auto axes = [&](const std::string& name, double factor) {
        return " X" + whole(factor * value(name + "_x")) + " Y" + whole(factor * value(name + "_y")) + " Z" +
               whole(factor * value(name + "_z")) + " E" + whole(factor * value(name + "_e"));
    };
    const double per_minute = rrf ? 60 : 1;
    std::string out = "M201" + axes("acceleration", 1) + " ; sets maximum accelerations, mm/sec^2\n";
    out +=
        "M203" + axes("feedrate", per_minute) + " ; sets maximum feedrates, " + (rrf ? "mm / min" : "mm / sec") + "\n";
    const std::string extruding = whole(value("acceleration_extruding"));
    const std::string travel = flavor == Flavor::marlin ? extruding : whole(value("acceleration_travel"));
    if (rrf)
        out += "M204 P" + extruding + " T" + travel + " ; sets acceleration (P, T), mm/sec^2\n";
    else
        out += "M204 P" + extruding + " R" + whole(value("acceleration_retracting")) + " T" + travel +
               " ; sets acceleration (P, T) and retract acceleration (R), mm/sec^2\n";
    out += rrf ? "M566" : "M205";
    for (const char* axis : {"x", "y", "z", "e"})
        out += std::string(" ") + static_cast<char>(axis[0] - 'a' + 'A') +
               with_two_decimals(per_minute * value(std::string("jerk_") + axis));
    out += std::string(" ; sets the jerk limits, ") + (rrf ? "mm/min" : "mm/sec") + "\n";
    if (!rrf && !orca)
        out += "M205 S" + whole(settings.number("machine_min_extruding_rate")) + " T" +
               whole(settings.number("machine_min_travel_rate")) +
               " ; sets the minimum extruding and travel feed rate, mm/sec\n";
    return out;
}

} // namespace filum::preset
