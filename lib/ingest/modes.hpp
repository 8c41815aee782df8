// What the codes of a program switch, and where its extruder is.
#pragma once

#include "machine/profile.hpp"

namespace filum::ingest {

struct Modes {
    explicit Modes(const machine::Profile& profile)
        : relative_extruder(profile.extrusion.relative && !profile.name.empty()) {}

    int motion = -1; // 0 to 3: G0 to G3, until another; -1: none yet
    bool relative = false, relative_extruder, extruder_told = false, relative_centres = true;
    double unit = 1;     // mm
    double extruder = 0; // units of the last word
    bool open = false;   // the valve, or the fibre

    // By how much the extruder goes forward.
    double pushed(double word) {
        const double by = relative_extruder ? word : word - extruder;
        extruder = relative_extruder ? extruder + word : word;
        return by;
    }
    // Of places; of the extruder, too, unless a code of its own was ever said, as Marlin does at first.
    void places(bool are_relative) {
        relative = are_relative;
        if (!extruder_told) relative_extruder = are_relative;
    }
    void extruder_is(bool is_relative) {
        relative_extruder = is_relative;
        extruder_told = true;
    }
};

} // namespace filum::ingest
