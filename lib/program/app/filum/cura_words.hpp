// Translates settings of Cura that depend on several keys.
#pragma once

#include "app/filum/cura_stack.hpp"
#include "app/filum/slicer_table.hpp"

#include <string>
#include <vector>

namespace filum::app::filum {

// The options that the setting `key` makes; none if another key of the same quantity makes them.  Throws Error(usage)
// for a value that Filum does not have, and for one that depends on a formula that cannot be calculated.
std::vector<std::string> cura_words(const CuraStack& stack, const std::string& key, const SettingRow& row,
                                    std::vector<std::string>& remarks);

} // namespace filum::app::filum
