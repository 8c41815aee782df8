// The table of slicers' settings, settings.tsv.  The build embeds it in the program.
#pragma once

#include "app/filum/slicer_file.hpp"

#include <string_view>
#include <vector>

namespace filum::app::filum {

enum class Use : std::uint8_t {
    used,
    none,   // the setting has no meaning in Filum
    later,  // the setting has a meaning, but Filum does not use it yet
    harm,   // as `later`, and a print without the setting can go wrong
    unknown // the table has no row for the setting
};

// One row of the table; a cell with '-' is empty here.
struct SettingRow {
    Use use = Use::unknown;
    std::string_view target;  // Filum's option, or a key of the machine profile
    std::string_view reading; // how the value is converted; see slicer_settings.cpp
    std::string_view of;      // the key that a percentage refers to
    std::string_view usual;   // the slicer's default
    std::string_view why;     // why the setting is not used
};

// The default values of the slicer, for keys that its presets may lack.
std::vector<SlicerSetting> defaults_of(Slicer slicer);

// The first row of the table that fits the key and the slicer.  Without one, a row whose `use` is Use::unknown.
SettingRow row_of(std::string_view key, Slicer slicer);

} // namespace filum::app::filum
