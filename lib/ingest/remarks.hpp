// What slicers tell in the comments of their programs.
#pragma once

#include "toolpath/path.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::ingest {

// What is told anywhere in a program, before it is followed.
struct Told {
    std::string by;                // "filum", "PrusaSlicer", ...: whose comments these are; "" for unknown
    bool layers = false;           // it says where layers begin
    std::int64_t lowest_layer = 0; // at most 0: Cura numbers rafts below it
    std::vector<double> diameters; // mm, of the filament of each tool; none if it says nothing
    bool volumetric = false;       // the extruder word counts mm3
    bool marlin = false;           // it says that it is for Marlin
    bool machinekit = false;       // ... for MachineKit, where G22 and G23 retract and give again
    char extruder = 'E';           // the extruder's word
};
Told told_by(std::string_view program);

// One comment, as it changes what follows.
struct Remark {
    bool layer = false;                      // a layer begins
    std::optional<std::int64_t> layer_index; // its number, where it is told
    std::optional<double> width, height;     // mm, of beads
    std::optional<toolpath::Feature> feature;
    std::optional<toolpath::Role> role; // of programs of our own
};
Remark remark_in(std::string_view comment, const Told& told);

} // namespace filum::ingest
