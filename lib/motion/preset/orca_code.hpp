// Commands that OrcaSlicer and Bambu Studio write beside the G-code of a profile: fans, chamber, pressure advance.
#pragma once

#include "preset/flavor.hpp"
#include "preset/settings.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace filum::preset {

// Whether the printer is one of Bambu Lab's, by the name of its model.
bool of_bambu_lab(const Settings& settings);

// Turns the fan of the part and the auxiliary fan off.
std::string fans_off(const Settings& settings);

// The commands between the last bead and the end code.
std::string orca_end(const Settings& settings);

// Heats the chamber to the highest temperature that the filaments of these tools want, and waits; or turns its heater
// off.  "" if no filament controls the chamber.
std::string chamber(const Settings& settings, const std::vector<std::uint32_t>& tools, bool heat);

// Sets the exhaust fan to the highest speed (`key`) of the filaments that filter the air; "" if none does.
std::string exhaust_fan(const Settings& settings, const std::vector<std::uint32_t>& tools, const char* key);

// Sets the pressure advance of a filament; "" if the filament leaves it to the printer.
std::string pressure_advance(const Settings& settings, Flavor flavor, std::uint32_t tool);

} // namespace filum::preset
