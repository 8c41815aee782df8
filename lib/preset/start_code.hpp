// What the G-code of a profile's start does itself, and what a slicer adds to it.
#pragma once

#include "preset/program.hpp"

#include <string>
#include <string_view>

namespace filum::preset {

// Whether lines set a temperature by one of two M codes (or G10 with S), and the last one that they set; -1: none.
struct TemperatureCommands {
    bool any = false;
    int celsius = -1;
};
TemperatureCommands temperature_commands(std::string_view text, int set, int set_and_wait, bool g10);

// Whether a line of the text is the command T of that tool.
bool changes_tool(std::string_view text, std::uint32_t tool);

// M201, M203, M204 and M205 (or M566), where the profile asks for them: "" for none.
std::string machine_limits(const Settings& settings, Flavor flavor);

// The names that slicers compute: total_layer_count, first_layer_print_min, ...
void set_job_values(const Job& job, bool orca, Settings& to);

} // namespace filum::preset
