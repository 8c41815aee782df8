#include "preset/orca_code.hpp"

#include "macro/macro.hpp"

#include <algorithm>

namespace filum::preset {

bool of_bambu_lab(const Settings& settings) { return settings.text("printer_model").starts_with("Bambu Lab"); }

std::string fans_off(const Settings& settings) {
    return settings.flag("auxiliary_fan") ? "M106 S0\nM106 P2 S0\n" : "M106 S0\n";
}

std::string orca_end(const Settings& settings) {
    return fans_off(settings) + (of_bambu_lab(settings) ? "M981 S0 P20000 ; close spaghetti detector\n" : "");
}

std::string chamber(const Settings& settings, const std::vector<std::uint32_t>& tools, bool heat) {
    bool active = false;
    double celsius = 0;
    for (const std::uint32_t tool : tools) {
        active = active || settings.flag("activate_chamber_temp_control", tool);
        celsius = std::max(celsius, settings.number("chamber_temperature", tool));
    }
    if (!active || !(celsius > 0)) return "";
    if (!heat) return "M141 S0 ; turn the heater of the chamber off\n";
    const bool fan = settings.flag("auxiliary_fan");
    return std::string(fan ? "M106 P2 S255\n" : "") + "M191 S" + std::to_string(static_cast<int>(celsius)) +
           " ; heat the chamber and wait\n" + (fan ? "M106 P2 S0\n" : "");
}

std::string exhaust_fan(const Settings& settings, const std::vector<std::uint32_t>& tools, const char* key) {
    bool active = false;
    double percent = 0;
    for (const std::uint32_t tool : tools) {
        if (!settings.flag("activate_air_filtration", tool)) continue;
        active = true;
        percent = std::max(percent, settings.number(key, tool));
    }
    return active ? "M106 P3 S" + std::to_string(static_cast<int>(percent / 100 * 255)) + "\n" : "";
}

std::string pressure_advance(const Settings& settings, Flavor flavor, std::uint32_t tool) {
    const double value = settings.number("pressure_advance", tool);
    if (!settings.flag("enable_pressure_advance", tool) || value < 0) return "";
    const std::string text = macro::text_of(macro::Value{value});
    if (of_bambu_lab(settings)) return "M900 K" + text + " L1000 M10 ; pressure advance\n";
    if (flavor == Flavor::klipper) return "SET_PRESSURE_ADVANCE ADVANCE=" + text + " ; pressure advance\n";
    return (flavor == Flavor::reprapfirmware ? "M572 D0 S" : "M900 K") + text + " ; pressure advance\n";
}

} // namespace filum::preset
