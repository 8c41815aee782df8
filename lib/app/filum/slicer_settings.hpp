// What the settings of a slicer ask of Filum, each value read as that slicer reads it.
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
    std::string why{};                // it is not used
    std::vector<std::string> words{}; // options of `print`; none where it asks for what Filum does anyway
};

struct SlicerWishes {
    std::vector<ReadSetting> settings; // in the order of the file
    std::vector<std::string> words;    // all options, each once
    std::vector<std::string> remarks;  // on values that were not taken as they stand
    bool supports = false;             // are asked for,
    bool supports_by_hand = false;     // only where bodies or painted faces say
};

// Values are read so: 0 is zero, but where a slicer means "by itself" with it; a percentage is one of what that slicer
// takes it of (a width in SuperSlicer and OrcaSlicer of the nozzle, in PrusaSlicer and Slic3r of the layer; a speed of
// another speed); a density without "%" up to 1 is a share in Slic3r's files; of a list the item of the extruder that
// prints perimeters; `nil` is not set.  `has`: whether a stage has an option of that name.
SlicerWishes wishes(const SlicerFile& file, const std::function<bool(std::string_view)>& has);

} // namespace filum::app::filum
