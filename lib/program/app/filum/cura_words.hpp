// Translates settings of Cura that depend on several keys.
#pragma once

#include "app/filum/slicer_table.hpp"
#include "app/filum/slicer_values.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::app::filum {

// The number that Cura has for a key: that of the file, or that of Cura's usual formula (columns `of` and `usual` of
// cura.tsv).  None if the file gives a formula, here or for a key that the usual formula needs.
std::optional<double> cura_number(const SlicerFile& file, std::string_view key);

// The options that the setting `key` makes; none if another key of the same quantity makes them.  Throws Error(usage)
// for a value that Filum does not have.
std::vector<std::string> cura_words(const SlicerValues& values, const std::string& key, const SettingRow& row,
                                    std::vector<std::string>& remarks);

} // namespace filum::app::filum
