#include "preset/flavor.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace filum::preset {

Flavor flavor_of(const std::string& word) {
    constexpr std::array<std::pair<std::string_view, Flavor>, 14> kNames{{{"reprap", Flavor::reprap},
                                                                          {"reprapfirmware", Flavor::reprapfirmware},
                                                                          {"repetier", Flavor::repetier},
                                                                          {"teacup", Flavor::teacup},
                                                                          {"makerware", Flavor::makerware},
                                                                          {"marlin", Flavor::marlin},
                                                                          {"marlin2", Flavor::marlin2},
                                                                          {"klipper", Flavor::klipper},
                                                                          {"sailfish", Flavor::sailfish},
                                                                          {"mach3", Flavor::mach3},
                                                                          {"machinekit", Flavor::machinekit},
                                                                          {"smoothie", Flavor::smoothie},
                                                                          {"no-extrusion", Flavor::no_extrusion},
                                                                          {"sprinter", Flavor::reprap}}};
    const auto* const found = std::ranges::find(kNames, word, [](const auto& pair) { return pair.first; });
    if (found == kNames.end())
        throw Error(Exit::bad_input, "cannot use gcode_flavor '" + word +
                                         "': Filum does not know it; known are marlin, marlin2, klipper, "
                                         "reprapfirmware, reprap, repetier, smoothie, teacup, mach3, machinekit");
    if (found->second == Flavor::makerware || found->second == Flavor::sailfish ||
        found->second == Flavor::no_extrusion)
        throw Error(Exit::bad_input, "cannot use gcode_flavor '" + word +
                                         "': Filum writes no programs for it; print with --machine NAME, or choose "
                                         "another flavour that the printer takes");
    return found->second;
}

namespace {

char temperature_letter(Flavor flavor) { return flavor == Flavor::mach3 || flavor == Flavor::machinekit ? 'P' : 'S'; }

} // namespace

std::string nozzle_temperature(Flavor flavor, int celsius, bool wait, int tool) {
    const bool rrf = flavor == Flavor::reprapfirmware, apart = rrf || flavor == Flavor::teacup;
    std::string out = wait && !apart ? "M109 " : rrf ? "G10 " : "M104 ";
    out += temperature_letter(flavor) + std::to_string(celsius);
    if (rrf && tool < 0) tool = 0; // G10 needs a tool
    if (tool >= 0) out += (rrf ? " P" : " T") + std::to_string(tool);
    out += wait && !apart ? " ; set temperature and wait for it to be reached\n" : " ; set temperature\n";
    if (wait && apart) out += "M116 ; wait for temperature to be reached\n";
    return out;
}

std::string bed_temperature(Flavor flavor, int celsius, bool wait) {
    const bool teacup = flavor == Flavor::teacup;
    std::string out =
        (wait && !teacup ? "M190 " : "M140 ") + std::string(1, temperature_letter(flavor)) + std::to_string(celsius) +
        (wait && !teacup ? " ; set bed temperature and wait for it to be reached\n" : " ; set bed temperature\n");
    if (wait && teacup) out += "M116 ; wait for bed temperature to be reached\n";
    return out;
}

std::string preamble(Flavor flavor, bool relative) {
    std::string out = "G21 ; set units to millimeters\nG90 ; use absolute coordinates\n";
    if (flavor == Flavor::mach3 || flavor == Flavor::machinekit) return out;
    out += relative ? "M83 ; use relative distances for extrusion\n" : "M82 ; use absolute distances for extrusion\n";
    return out + reset_extruder(flavor, relative);
}

std::string reset_extruder(Flavor flavor, bool relative) {
    if (relative || flavor == Flavor::mach3) return "";
    return std::string("G92 ") + extruder_letter(flavor) + "0\n";
}

char extruder_letter(Flavor flavor) { return flavor == Flavor::mach3 || flavor == Flavor::machinekit ? 'A' : 'E'; }

} // namespace filum::preset
