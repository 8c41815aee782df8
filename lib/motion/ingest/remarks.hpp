// Reads the comments that slicers write into their programs.
#pragma once

#include "toolpath/path.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace filum::ingest {

// Facts from comments anywhere in a program, collected before the program is followed.
struct ProgramTraits {
    std::string by;                // author of the program: "filum", "PrusaSlicer", ...; "" for unknown
    bool layers = false;           // comments mark where layers begin
    std::int64_t lowest_layer = 0; // at most 0, as Cura gives rafts negative numbers
    std::vector<double> diameters; // mm, filament diameter of each tool; empty: unknown
    bool volumetric = false;       // the extruder word counts mm3
    bool marlin = false;           // the program is for Marlin
    bool machinekit = false;       // the program is for MachineKit, where G22 and G23 retract and return
    char extruder = 'E';           // letter of the extruder word
};
ProgramTraits traits_of(std::string_view program);

// The changes that one comment makes to the moves after it.
struct Remark {
    bool layer = false;                      // a layer begins
    std::optional<std::int64_t> layer_index; // number of the layer, if the comment gives it
    std::optional<double> width, height;     // mm, size of beads
    std::optional<toolpath::Feature> feature;
    std::optional<toolpath::Role> role; // only in programs of Filum
};
Remark remark_in(std::string_view comment, const ProgramTraits& traits);

} // namespace filum::ingest
