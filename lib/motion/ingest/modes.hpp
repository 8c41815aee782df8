// The modal state of a program, and the position of its extruder.
#pragma once

#include "base/length_unit.hpp"
#include "machine/profile.hpp"

#include <cmath>

namespace filum::ingest {

struct Modes {
    explicit Modes(const machine::Profile& profile)
        : relative_extruder(profile.extrusion.relative && !profile.name.empty()) {}

    int motion = -1; // 0 to 3: the last of G0 to G3; -1: none yet
    bool relative = false, relative_extruder, extruder_told = false, relative_centres = true;
    int plane = 17;      // plane of arcs; 17, for G17, is XY
    double extruder = 0; // position after the last word, in its unit
    bool open = false;   // the valve is open, or the fibre is on

    void inches(bool are) { unit_ = are ? kInch : 1; }
    [[nodiscard]] double unit() const { return unit_; } // mm per unit of length

    // Applies a code that changes how words are read.  Ignores other codes.
    void modal(double g) {
        const auto is = [g](double code) { return std::abs(g - code) < 1e-3; };
        if (is(17) || is(18) || is(19)) plane = static_cast<int>(std::lround(g));
        if (is(90) || is(91)) places(is(91));
        if (is(90.1) || is(91.1)) relative_centres = is(91.1);
    }

    // Updates the extruder's position by a word.  Returns its advance.
    double pushed(double word) {
        const double by = relative_extruder ? word : word - extruder;
        extruder = relative_extruder ? extruder + word : word;
        return by;
    }
    // Sets whether coordinates are relative. This applies to the extruder too, until a code of its own (M82, M83)
    // appears, as in Marlin.
    void places(bool are_relative) {
        relative = are_relative;
        if (!extruder_told) relative_extruder = are_relative;
    }
    void extruder_is(bool is_relative) {
        relative_extruder = is_relative;
        extruder_told = true;
    }

  private:
    double unit_ = 1;
};

} // namespace filum::ingest
