// Reads which commands a profile's start G-code already contains, and writes those that a slicer adds.
#pragma once

#include "preset/program.hpp"

#include <string>
#include <string_view>

namespace filum::preset {

// The temperature commands in a text (two M codes, or G10 with S).  `celsius`: the last value set; -1: none.
struct TemperatureCommands {
    bool any = false;
    int celsius = -1;
};
TemperatureCommands temperature_commands(std::string_view text, int set, int set_and_wait, bool g10);

// True if a line of the text selects that tool by T.
bool changes_tool(std::string_view text, std::uint32_t tool);

// M201, M203, M204 and M205 (or M566) if the profile asks for them, or "".
std::string machine_limits(const Settings& settings, Flavor flavor);

// Sets the values that slicers compute: total_layer_count, first_layer_print_min, ...
void set_job_values(const Job& job, bool orca, Settings& to);

} // namespace filum::preset
