// Commands as the firmware of a printer takes them.
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
    marlin,  // before 2.0
    marlin2, // since
    klipper,
    sailfish,
    mach3,
    machinekit,
    smoothie,
    no_extrusion,
};

// Throws Error(bad_input) for an unknown word, and for a firmware that Filum writes no programs for.
Flavor flavor_of(const std::string& word);

// Degrees Celsius.  `tool`: -1 where there is one only.  Lines with line ends.
std::string nozzle_temperature(Flavor flavor, int celsius, bool wait, int tool);
std::string bed_temperature(Flavor flavor, int celsius, bool wait);

// Millimetres, absolute coordinates, how extruder words count.
std::string preamble(Flavor flavor, bool relative);
std::string reset_extruder(Flavor flavor, bool relative);
char extruder_letter(Flavor flavor);

} // namespace filum::preset
