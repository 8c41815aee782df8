// The rows of the table of settings for one slicer.
#pragma once

#include "app/filum/slicer_file.hpp"
#include "preset/table.hpp"

#include <string_view>
#include <vector>

namespace filum::app::filum {

using preset::SettingRow;
using preset::Use;

// The word for a slicer in the table: "prusa", "orca", "unknown", ...
std::string_view table_word(Slicer slicer);

// The default values of the slicer, for keys that its presets may lack.
std::vector<SlicerSetting> defaults_of(Slicer slicer);

// The first row of the table that fits the key and the slicer.  Without one, a row whose `use` is Use::unknown.
SettingRow row_of(std::string_view key, Slicer slicer);

} // namespace filum::app::filum
