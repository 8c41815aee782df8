// Commands in the dialect of a printer's firmware.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace filum::preset {

enum class Flavor : std::uint8_t {
    reprap,
    reprapfirmware,
    repetier,
    teacup,
    makerware,
    marlin,  // Marlin before 2.0
    marlin2, // Marlin 2.0 and later
    klipper,
    sailfish,
    mach3,
    machinekit,
    smoothie,
    no_extrusion,
};

// The flavor that a setting names.  Throws Error(bad_input) for an unknown one, or one that Filum does not write.
Flavor flavor_of(const std::string& word);

// Commands that set a temperature in degrees Celsius, with line ends.  `tool`: -1 if there is only one.
std::string nozzle_temperature(Flavor flavor, int celsius, bool wait, int tool);
std::string bed_temperature(Flavor flavor, int celsius, bool wait);

// Commands that set millimetres, absolute coordinates, and relative or absolute extruder words.
std::string preamble(Flavor flavor, bool relative);
std::string reset_extruder(Flavor flavor, bool relative);
char extruder_letter(Flavor flavor);

} // namespace filum::preset
