// Translates the settings of a slicer to options of Filum.  Each value is read as that slicer reads it.
#pragma once

#include "app/filum/slicer_table.hpp"

#include <functional>
#include <string>
#include <vector>

namespace filum::app::filum {

// One setting of a file.
struct ReadSetting {
    std::string key, value;
    Use use = Use::unknown;
    std::string why{};                // why the setting is not used
    std::vector<std::string> words{}; // options of `print`; none if Filum does anyway what the setting asks for
};

struct SlicerWishes {
    std::vector<ReadSetting> settings; // in the order of the file
    std::vector<std::string> words;    // the options of all settings
    std::vector<std::string> remarks;  // values that were changed, a sentence for each
    bool supports = false;             // the settings ask for supports
    bool supports_by_hand = false;     // supports are wanted only at bodies and painted faces that ask for them
};

// The options that the settings of a file ask for.  `has`: whether a stage has an option of that name.  Rules for
// values:
//   - 0 means zero, except where the slicer takes it as "automatic".
//   - A percentage refers to the same quantity as in that slicer.  A width refers to the nozzle in SuperSlicer and
//     OrcaSlicer, and to the layer height in PrusaSlicer and Slic3r.  A speed refers to another speed.
//   - A density without "%" that is at most 1 is a fraction, except in OrcaSlicer and Bambu Studio.
//   - Of a list, the item of the extruder that prints perimeters counts.
//   - `nil` means not set.
SlicerWishes wishes(const SlicerFile& file, const std::function<bool(std::string_view)>& has);

} // namespace filum::app::filum
