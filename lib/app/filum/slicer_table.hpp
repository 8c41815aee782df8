// The table of slicers' settings, settings.tsv, which the build puts into the program.
#pragma once

#include "app/filum/slicer_file.hpp"

#include <string_view>
#include <vector>

namespace filum::app::filum {

enum class Use : std::uint8_t {
    used,
    none,  // it has no meaning here
    later, // it has one, but Filum does not use it yet
    harm,  // the same, and a print without it can go wrong
    unknown
};

// One row; empty where the table has a '-'.
struct SettingRow {
    Use use = Use::unknown;
    std::string_view target;  // our option, or a key of the machine's profile
    std::string_view reading; // how the value becomes one of ours; see slicer_settings.cpp
    std::string_view of;      // the key that a percentage refers to
    std::string_view usual;   // the slicer's default
    std::string_view why;     // it is not used
};

// Keys that the slicer has a value for where a preset lacks it, with that value.
std::vector<SlicerSetting> defaults_of(Slicer slicer);

// The first row that fits; one of unknown use if there is none.
SettingRow row_of(std::string_view key, Slicer slicer);

} // namespace filum::app::filum
